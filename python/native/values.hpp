// Python objects as values of the library, and back.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <arenite_host/value.hpp>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace arenite::python {

namespace py = pybind11;

/// Three numbers that Python changes between steps.
struct Signal {
  HostSignal value = std::make_shared<std::array<double, 3>>();
};

/// Exceptions of Python functions on threads that cannot throw: loops of the library. The first is kept.
class Raised {
 public:
  static Raised& instance() {
    static Raised raised;
    return raised;
  }
  void keep(std::exception_ptr e) {
    const std::lock_guard lock(mutex_);
    if (!kept_) kept_ = std::move(e);
  }
  /// Throws what was kept, if there is something.
  void rethrow() {
    std::exception_ptr e;
    {
      const std::lock_guard lock(mutex_);
      std::swap(e, kept_);
    }
    if (e) std::rethrow_exception(e);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr kept_;
};

/// Whether this thread is within a call from Python, which may be left by an exception.
inline bool& may_throw() {
  thread_local bool value = false;
  return value;
}

/// Marks a call from Python as long as it lives.
class CallFromPython {
 public:
  CallFromPython() : outer_{may_throw()} { may_throw() = true; }
  ~CallFromPython() { may_throw() = outer_; }
  CallFromPython(const CallFromPython&) = delete;
  CallFromPython& operator=(const CallFromPython&) = delete;

 private:
  bool outer_;
};

/// The name of an object in messages: its text in Python, cut.
inline std::string text_of(py::handle object) {
  constexpr std::size_t most = 80;
  const auto text = py::repr(object).cast<std::string>();
  return text.size() > most ? text.substr(0, most) + " .." : text;
}
/// The name of a function in messages: "speed (drop.py:12)".
inline std::string name_of(py::object f) {
  while (py::hasattr(f, "__wrapped__")) f = f.attr("__wrapped__");
  if (!py::hasattr(f, "__qualname__")) return text_of(f);
  const auto name = f.attr("__qualname__").cast<std::string>();
  if (!py::hasattr(f, "__code__")) return name;
  const py::object code = f.attr("__code__");
  const auto file = code.attr("co_filename").cast<std::string>();
  return joined_text({name, " (", file.substr(file.find_last_of('/') + 1), ":",
                      code.attr("co_firstlineno").cast<int>(), ")"});
}

/// Numbers of any real type, or bools, in rows. Nothing, texts and objects are none, though NumPy makes
/// numbers of some. Empty: they are no numbers.
inline std::optional<HostArray> numbers_of(py::handle object) {
  const auto any = py::array::ensure(object);
  if (!any || std::string_view("biuf").find(any.dtype().kind()) == std::string_view::npos) return {};
  const auto given = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(any);
  if (!given) return {};
  HostArray a;
  a.numbers.assign(given.data(), given.data() + given.size());
  for (py::ssize_t k = 0; k < given.ndim(); ++k) a.shape.push_back(static_cast<std::size_t>(given.shape(k)));
  return a;
}
inline HostArray array_of(py::handle object) {
  if (auto a = numbers_of(object)) return *std::move(a);
  throw error(joined_text({"array = ", text_of(object), ": must hold numbers"}));
}

inline py::array_t<double> numpy_of(const std::vector<double>& numbers, std::vector<py::ssize_t> shape) {
  py::array_t<double> a(std::move(shape));
  std::copy(numbers.begin(), numbers.end(), a.mutable_data());
  return a;
}

/// A Python function that takes an array [rows, columns] and returns one with as many rows. Called on any
/// thread, without the interpreter's lock.
inline HostFunction function_of(py::object callable) {
  // The last copy may die on a thread without the lock.
  const std::shared_ptr<py::object> held(new py::object(std::move(callable)), [](py::object* o) {
    const py::gil_scoped_acquire lock;
    delete o;
  });
  return [held](const HostArray& in) -> HostArray {
    const py::gil_scoped_acquire lock;
    try {
      std::vector<py::ssize_t> shape(in.shape.begin(), in.shape.end());
      const py::object out = (*held)(numpy_of(in.numbers, std::move(shape)));
      if (auto a = numbers_of(out)) return *std::move(a);
      throw error(joined_text({"function = ", name_of(*held), ": returned ", text_of(out),
                               ": must return numbers, a row for each of ", in.rows(), " rows"}));
    } catch (...) {
      if (may_throw()) throw;
      Raised::instance().keep(std::current_exception());
      const std::size_t rows = in.rows();
      return {std::vector<double>(rows, std::numeric_limits<double>::quiet_NaN()), {rows, 1}};
    }
  };
}

inline Value value_of(py::handle object) {
  if (object.is_none()) return {};
  if (py::isinstance<Signal>(object)) return object.cast<const Signal&>().value;
  if (py::isinstance<py::bool_>(object)) return object.cast<bool>();
  if (py::isinstance<py::str>(object)) return object.cast<std::string>();
  if (py::isinstance<py::dict>(object)) {
    Value::Dict all;
    for (const auto& [key, value] : py::reinterpret_borrow<py::dict>(object))
      all.emplace(key.cast<std::string>(), value_of(value));
    return all;
  }
  if (py::isinstance<py::array>(object)) {
    HostArray a = array_of(object);
    if (a.shape.empty()) return a.numbers.front();
    return std::make_shared<const HostArray>(std::move(a));
  }
  if (py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object)) {
    Value::List all;
    for (const auto& item : py::reinterpret_borrow<py::sequence>(object)) all.push_back(value_of(item));
    return all;
  }
  if (PyCallable_Check(object.ptr()))
    return std::make_shared<const HostFunction>(function_of(py::reinterpret_borrow<py::object>(object)));
  const double number = PyFloat_AsDouble(object.ptr());  // numbers of any kind
  if (PyErr_Occurred() == nullptr) return number;
  PyErr_Clear();
  throw error(joined_text(
      {"value = ", text_of(object), ": must be a number, a word, a list, an array, a function or a recipe"}));
}

}  // namespace arenite::python
