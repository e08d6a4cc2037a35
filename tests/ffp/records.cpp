// Records as users have them: one motion whose depth is known, in every disguise of a table. Each gives that
// depth, or a sentence that names the line.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../../examples/ffp/command/read_reduce.hpp"
#include "../../examples/ffp/reduce/read_measurement.hpp"
#include "../../examples/ffp/reduce/reduction.hpp"
#include "../../examples/ffp/reduce/reduction_files.hpp"
#include "catch.hpp"

using namespace arenite;
using namespace arenite::ffp;

namespace {

constexpr double g = standard_gravity;

Reduction reduced(const std::string& file, std::vector<std::string> words = {}) {
  words.insert(words.begin(), file);
  std::ostringstream answer;
  const auto o = read_reduce(words, answer);
  return reduce(read_measurement(*o), *o);
}

std::string refusal(const std::string& file, const std::vector<std::string>& words = {}) {
  try {
    reduced(file, words);
  } catch (const error& e) {
    return e.what();
  }
  return "accepted";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string written(const std::string& name, const std::string& text) {
  std::ofstream{name, std::ios::binary} << text;
  return name;
}

/// At rest, in free fall for half a second, slowed by half a sine for 46 ms, at rest: g, at 2 kHz.
struct Fall {
  double before = 0.4, fall = 0.5, braking = 0.046, after = 0.5;  // s
  double peak = 0.5 * pi / 2 / 0.046;                             // g: takes the whole velocity
  double velocity() const { return g * fall; }
  double depth() const { return velocity() * braking / 2; }  // m

  std::vector<double> record(double rate = 2000) const {
    std::vector<double> net;
    for (double t = -before - fall; t < braking + after;
         t = -before - fall + static_cast<double>(net.size()) / rate)
      net.push_back(t < -fall || t > braking ? 0 : t < 0 ? -1 : peak * std::sin(pi * t / braking));
    return net;
  }
};

/// A table of it: header, text between the fields, decimal mark, end of the lines.
struct Form {
  std::string header = "time_s,deceleration_g", separator = ",", mark = ".", end = "\n", quote = "";

  std::string number(double x) const {
    std::string text = joined_text({x});
    if (const auto at = text.find('.'); at != std::string::npos) text.replace(at, 1, mark);
    return quote + text + quote;
  }
  std::string table(const std::vector<double>& values, double rate = 2000) const {
    std::string text = header + end;
    for (std::size_t i = 0; i < values.size(); ++i)
      text += number(static_cast<double>(i) / rate) + separator + number(values[i]) + end;
    return text;
  }
};

std::string utf16(const std::string& text) {
  std::string wide = "\xff\xfe";
  for (const char c : text) wide += {c, '\0'};
  return wide;
}

}  // namespace

TEST_CASE("one motion in every form of a table") {
  const Fall motion;
  const auto record = motion.record();
  const double depth = reduced(written("plain.csv", Form{}.table(record))).greatest_depth;
  REQUIRE(std::abs(depth / motion.depth() - 1) < 0.02);
  const std::string semicolons = "time_s;deceleration_g", tabs = "time_s\tdeceleration_g";
  for (const Form& form :
       {Form{.header = semicolons, .separator = ";", .mark = ","},
        Form{.header = tabs, .separator = "\t", .mark = ","},
        Form{.header = "time_s deceleration_g", .separator = "  ", .mark = ","},
        Form{.mark = ",", .quote = "\""}, Form{.header = "\"time, s\",\"deceleration, g\"", .quote = "\""},
        Form{.header = "Time, s;Acceleration, g", .separator = ";", .mark = ","},
        Form{.header = "\xef\xbb\xbf" + semicolons, .separator = ";", .mark = ",", .end = "\r\n"},
        Form{.header = tabs + "\t", .separator = "\t", .end = "\t\n"},
        Form{.header = semicolons, .separator = ";", .mark = ",", .end = ";;;\r\n"},
        Form{.header = "Drop 3; 12:30, sand\n\nsep=;\n# a remark\n" + semicolons, .separator = ";"},
        Form{.header = "Time;Acceleration\n[s];[g]", .separator = ";", .mark = ","},
        Form{.header = "time_s,time_step_s,deceleration_g", .separator = ",1,"}}) {
    INFO(form.header);
    REQUIRE(std::abs(reduced(written("form.csv", form.table(record))).greatest_depth - depth) < 1e-9);
  }
  std::vector<double> in_m_s2;
  for (const double a : record) in_m_s2.push_back(a * g);
  for (const char* unit : {"m/s\xc2\xb2", "m/s\xb2", "m/s^2", "m s^2"}) {
    const Form form{.header = joined_text({"t (s);Acceleration (", unit, ")"}), .separator = ";"};
    REQUIRE(std::abs(reduced(written("form.csv", form.table(in_m_s2))).greatest_depth - depth) < 1e-9);
  }
}

TEST_CASE("a table that may be read in two ways, or in none, is refused with its line") {
  const auto of = [](const std::string& text) { return refusal(written("t.csv", text)); };
  const std::string head = "time_s,deceleration_g\n", european = "time_ms;deceleration_g\n";
  const auto record = Fall{}.record();
  REQUIRE(
      of(Form{.mark = ","}.table(record)) ==
      "t.csv: line 3, number of fields = 3: must be 2, as in the header; numbers with decimal commas need "
      "semicolons between them");
  REQUIRE(holds(of(head + "0,00,1,00\n"), "line 2, number of fields = 4: must be 2"));
  REQUIRE(of(european + "0,0.00\n") == "t.csv: line 2, number of fields = 1: must be 2, as in the header");
  REQUIRE(of(head + "0;0,00\n") == "t.csv: line 2, column time_s = 0;0: must be a number");
  REQUIRE(holds(of(head + "0,0\n1,1,5\n"), "line 3, number of fields = 3"));
  REQUIRE(holds(of(head + "0,0\n1\n"), "line 3, number of fields = 1"));
  // Thousands.
  for (const char* number : {"1.234,5", "1,234.5"})
    REQUIRE(of(european + "0;" + number + "\n") ==
            joined_text({"t.csv: line 2, column deceleration_g = ", number,
                         ": a file has one decimal mark and none between thousands; line 2 has a comma, line "
                         "2 a point"}));
  REQUIRE(holds(of(european + "0,5;1\n1;1.5\n"),
                "line 3, column deceleration_g = 1.5: a file has one decimal mark"));
  REQUIRE(of(european + "1,000;-1\n1,001;20\n") ==
          "t.csv: line 2: 1,000 may have a decimal comma, or a mark between thousands, and no other number "
          "tells; "
          "write points");
  REQUIRE(holds(of(european + "999;-1\n1,000;20,5\n"), "line 3, column time_ms = 1,000: must be greater"));
  for (const char* number : {"1,234,567", "1 234", "1'234", "5 %", "0,5 g", "-", "inf", "NaN", "",
                             "\xe2\x88\x92"
                             "1"})
    REQUIRE(holds(of(european + "0;1\n1;" + number + "\n"),
                  joined_text({"line 3, column deceleration_g = ", number, ": must be a number"})));
  REQUIRE(of("time_s;acc_g\n12:34:56.789;1\n") ==
          "t.csv: line 2, column time_s = 12:34:56.789: must be a number; turn times of the clock into "
          "seconds, or give --rate");
  // Rows.
  REQUIRE(holds(of(head + "0,1\n# a remark\n\n0,1\n"),
                "line 5, column time_s = 0: must be greater than the time before, 0"));
  REQUIRE(holds(of(head + "1,0\n0.9,0\n"),
                "line 3, column time_s = 0.9: must be greater than the time before, 1"));
  REQUIRE(holds(of(head + "0,1\nEnd of the record\n"), "line 3"));
  REQUIRE(
      of("Time;Acceleration\n[s];[%]\n0;1\n") ==
      "t.csv: line 2, column Acceleration = [%]: must be a number, or in the row below the header a unit");
  REQUIRE(holds(of("Time_s;acc\n[ms];[g]\n0;1\n"),
                "line 2, column Time_s = [ms]: is another unit than the header's"));
  REQUIRE(
      of("time_s,acc_x_g,acc_y_g\n0,1,1\n") ==
      "t.csv: columns acc_x_g and acc_y_g may both be the deceleration; give --column with the name or the "
      "number of the one that is meant");
  REQUIRE(holds(of("time_s,time_s,acc_g\n0,0,1\n"), "columns time_s and time_s may both be the time"));
  REQUIRE(holds(of("Time of the test\n0,1\n"), "has no column of deceleration"));
  // Text.
  const std::string text = Form{}.table(record);
  REQUIRE(of(utf16(text)) == "t.csv: is UTF-16, or no text; save it as text in UTF-8 (CSV)");
  REQUIRE(holds(of(utf16(text).substr(2)), "is UTF-16, or no text"));
  REQUIRE(of("time_s,acc_g\r0,1\r") == "t.csv: line 1: holds a CR; lines must end with LF or CR LF");
  REQUIRE(of(head + "\"0,1\n") == "t.csv: line 2: leaves a quote open");
}

namespace {

/// A table of columns, with all of their digits.
std::string columns_text(const std::string& header, const std::string& separator,
                         const std::vector<std::vector<double>>& columns) {
  std::string text = header;
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    for (const auto& column : columns) text += (&column == &columns[0] ? "" : separator) + exactly(column[i]);
    text += "\n";
  }
  return text;
}

using Words = std::vector<std::string>;

Words joined(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

TEST_CASE(
    "columns by name or number, rows without a time, and three axes give the motion of the plain record") {
  const Fall motion;
  const auto net = motion.record();
  std::vector<double> time, in_m_s2, other(net.size(), 3);
  for (std::size_t i = 0; i < net.size(); ++i) time.push_back(static_cast<double>(i) / 2000);
  for (const double a : net) in_m_s2.push_back(a * g);
  std::vector<std::vector<double>> axes(3);  // turned: (2, 3, 6) / 7 is of length 1
  for (const double a : net)
    for (std::size_t k = 0; const double along : {2., 3., 6.}) axes[k++].push_back((a + 1) * along / 7);
  const auto plain = reduced(written("plain.csv", columns_text("time_s,deceleration_g\n", ",", {time, net})));
  REQUIRE(std::abs(plain.greatest_depth / motion.depth() - 1) < 0.02);
  REQUIRE(std::abs(plain.motion.impact_velocity / motion.velocity() - 1) < 2e-3);
  REQUIRE(std::abs(plain.peak_g() / motion.peak - 1) < 1e-2);
  const auto same = [&](const std::string& text, const Words& words, const std::string& note) {
    INFO(text.substr(0, 60));
    const auto r = reduced(written("columns.csv", text), words);
    CAPTURE(r.notes[0]);
    REQUIRE(std::abs(r.greatest_depth / plain.greatest_depth - 1) < 1e-9);
    REQUIRE(std::abs(r.motion.impact_velocity / plain.motion.impact_velocity - 1) < 1e-9);
    REQUIRE(std::abs(r.peak_g() / plain.peak_g() - 1) < 1e-9);
    REQUIRE(holds(r.notes[0], note));
  };
  // By name, where others could be meant, or none.
  const std::string several = "time_s,acc_x_g,\"acc, y [m/s^2]\",stamp,raw\n";
  const std::vector<std::vector<double>> of_several{other, other, in_m_s2, time, net};
  const Words stamp{"--time-column", "stamp", "--time-unit", "s"};
  for (const char* name : {"acc, y [m/s^2]", "\"acc, y [m/s^2]\"", "3"})
    same(columns_text(several, ",", of_several), joined({"--column", name}, stamp),
         "time is stamp (times 1 s), deceleration is acc, y [m/s^2] (times 1 m/s^2)");
  same(columns_text(several, ",", of_several),
       joined({"--column", "raw", "--deceleration-unit", "g", "--threshold", "-0.8"}, stamp),
       "deceleration is raw (times 9.81 m/s^2)");
  same(columns_text("time;2;1\n[s];[g];[g]\n", ";", {time, other, net}), {"--column", "1"},
       "deceleration is 1 (");
  // Without a time.
  const Words rate{"--rate", "2000"};
  same(columns_text("n,acc_g\n", ",", {other, net}), rate, "time is row / 2000 Hz, deceleration is acc_g");
  for (const char* header : {"Acceleration (g)\n", "acceleration\n[g]\n", "acc_g\n"})
    same(columns_text(header, ",", {net}), rate, "time is row / 2000 Hz");
  same(columns_text("acc_g n\n", " ", {net, other}), rate, "deceleration is acc_g");
  same(columns_text("acc,raw g\n", ",", {net, other}), joined({"--deceleration-unit", "g"}, rate),
       "deceleration is acc (");
  same(columns_text("acc_x_g,acc_y_g\n", ",", {other, net}), joined({"--column", "acc_y_g"}, rate),
       "acc_y_g");
  same(columns_text("time_s,acc_g\n", ",", {other, net}), rate,
       "time is row / 2000 Hz (column time_s is not read), ");
  // Without a header, or with one that says nothing.
  const Words units{"--time-unit", "s", "--deceleration-unit", "g"};
  for (const char* separator : {"\t", ";", ",", ", ", " "})
    for (const char* header : {"", "# 1 2 3\n", "Drop, on a warm day\n", "Drop; 8\n\nOf today\n"})
      same(columns_text(header, separator, {other, time, net}),
           joined({"--time-column", "2", "--column", "3"}, units),
           "time is column 2 (times 1 s), deceleration is column 3 (");
  for (const char* header : {"x;y;z [g]\n", "Drop; of; today\nx;y;z\n[mm];[s];[g]\n"})
    same(columns_text(header, ";", {other, time, net}),
         {"--time-column", "2", "--column", "3", "--time-unit", "s"}, "[g] (times 9.81");
  same(columns_text("", ",", {net}), {"--column", "1", "--rate", "2000", "--deceleration-unit", "g"},
       "column 1");
  same(Form{.header = "", .separator = ";", .mark = ","}.table(net).substr(1),
       joined({"--time-column", "1", "--column", "2"}, units), "column 2");
  // Three axes.
  const std::vector<std::vector<double>> turned{time, axes[0], axes[1], axes[2]};
  for (const char* names : {"ax_g,\"a, y [g]\",az_g", "2,3,4", "az_g,ax_g,3"})
    same(columns_text("time_s,ax_g,\"a, y [g]\",az_g\n", ",", turned),
         {"--column", names, "--reads", "proper"}, "deceleration is the magnitude of a");
  same(columns_text("", " ", axes),
       joined({"--column", "1,2,3", "--reads", "proper", "--deceleration-unit", "g"}, rate),
       "the magnitude of column 1, column 2, column 3 (");
}

TEST_CASE("columns that a table does not have, or that cannot be meant, are refused with the cure") {
  const auto of = [](const std::string& text, const Words& words) {
    return refusal(written("c.csv", text), words);
  };
  const std::string table = "time_s,ax_g,ay_g,az_m_s2,raw,raw\n0,1,1,1,1,1\n1,1,1,1,2,2\n",
                    its = "; its columns: time_s, ax_g, ay_g, az_m_s2, raw, raw", proper = "proper";
  REQUIRE(of(table, {"--column", "acc"}) == "--column = acc: c.csv has no such column" + its);
  REQUIRE(of(table, {"--column", "acc", "--rate", "100"}) ==
          "--column = acc: c.csv has no such column" + its);
  REQUIRE(of(table, {"--column", "7"}) == "--column = 7: c.csv has no such column" + its);
  for (const char* number : {"0", "-1", "1.5", "AX_G", "99999999999999999999"})
    REQUIRE(holds(of(table, {"--column", number}), " has no such column"));
  REQUIRE(of(table, {"--time-column", "t"}) == "--time-column = t: c.csv has no such column" + its);
  REQUIRE(of("n,acc_g,flag\n0,1,ok\n", {"--column", "acc", "--rate", "100"}) ==
          "--column = acc: c.csv has no such column; its columns: n, acc_g, flag");
  for (const auto& [text, columns] : {std::pair{"Monday, 3\n\nn x y\n1 2 3\n", "n, x, y"},
                                      {"Of Monday at noon\nn;x;y\n[1];[g];[g]\n1;2;3\n", "n, x, y"},
                                      {"Kanal 1 [g]\n0,25\n", "Kanal 1 [g]"}})
    REQUIRE(of(text, {"--column", "acc", "--rate", "100"}) ==
            joined_text({"--column = acc: c.csv has no such column; its columns: ", columns}));
  REQUIRE(
      holds(of("Monday, 3\n1;2;3\n", {"--column", "acc", "--rate", "100"}), "line 2 is a row of numbers"));
  REQUIRE(holds(of(table, {"--column", "raw"}), "has several of this name; give its number; its columns: "));
  REQUIRE(of(table, {"--column", "5"}) ==
          "c.csv: column = raw: names no unit; write deceleration_g or deceleration_m_s2, or give "
          "--deceleration-unit");
  REQUIRE(holds(of(table, {"--column", "ax_g", "--time-column", "5"}), "or give --time-unit"));
  REQUIRE(holds(of(table, {"--column", "time_s"}), "time_s cannot be both time and deceleration"));
  REQUIRE(holds(of("n,pressure\n0,1\n", {}),
                "its columns: n, pressure; give --time-column or --rate, and --column"));
  REQUIRE(holds(of("n,acc_g\n0,1\n", {}), "; give --time-column or --rate"));
  REQUIRE(holds(of("0,1\n1,1\n", {}), "or give the numbers of columns to --column, and to --time-column or"));
  // Three.
  REQUIRE(holds(of(table, {"--column", "ax_g,ay_g"}), "must be one column, or three as X,Y,Z; put quotes"));
  REQUIRE(holds(of(table, {"--time-column", "ax_g,ay_g,raw"}), "must be one column; put quotes"));
  REQUIRE(holds(of(table, {"--column", "2,3,ax_g", "--reads", proper}), "names a column twice"));
  REQUIRE(holds(of(table, {"--column", "2,3,4", "--reads", proper}),
                "ax_g, ay_g and az_m_s2 must have one unit"));
  REQUIRE(holds(of(table, {"--column", "2,3,5", "--reads", proper}), "raw: names no unit"));
  REQUIRE(holds(of(table, {"--column", "2,3,4"}), "three columns go with --reads proper alone"));
  REQUIRE(
      holds(of(table, {"--column", "2,3,4", "--reads", proper, "--invert"}), "--invert: goes without three"));
  // Rows.
  const Words numbers{"--time-column", "1", "--column", "2", "--time-unit", "s", "--deceleration-unit", "g"};
  const Words rate{"--rate", "1000", "--column", "1", "--deceleration-unit", "g"};
  REQUIRE(of("0,1\n1,nan\n", numbers) == "c.csv: line 2, column 2 = nan: must be a number");
  REQUIRE(holds(of("1,1\n1,2\n", numbers), "line 2, column 1 = 1: must be greater than the time before, 1"));
  for (const char* gap : {"\n", "# lost\n", ";;\n"})
    REQUIRE(holds(of(joined_text({"1;2\n", gap, "1;2\n"}), rate),
                  "line 3: must follow the row before without lines that are empty or have #"));
  REQUIRE(holds(of("inf\n1\n", rate), "line 1, column 1 = inf: must be a number"));
  REQUIRE(of("0,\n1,1\n2,1\n", numbers) ==
          "c.csv: line 1 = 0,: must be a row of 2 numbers, as the one below it; put # before a title");
  REQUIRE(holds(of("0,1\n1\n", numbers), "line 2, number of fields = 1: must be 2"));
  REQUIRE(
      holds(of("0,125\n0,250\n", rate), "line 1 = 0,125: may be one number with a decimal comma, or two"));
  REQUIRE(of("12:30,1\n12:31,1\n", numbers) ==
          "c.csv: has no row of 2 or more numbers alone; give columns by their names in a header");
  REQUIRE(holds(of("", numbers), "is not empty"));
  // Options.
  for (const char* option : {"--column", "--time-column"})
    REQUIRE(of(table, {option, ""}) == joined_text({option, " = : needs a value"}));
  for (const char* hz : {"9.99", "1000001", "nan", "-2000", "0"})
    REQUIRE(
        holds(of(table, {"--rate", hz}), joined_text({"--rate = ", hz, ": must lie in [10, 1000000] Hz"})));
  REQUIRE(holds(of(table, {"--rate", "10", "--time-column", "1"}), "--time-column: goes without --rate"));
  REQUIRE(holds(of(table, {"--rate", "10", "--time-unit", "s"}), "--time-unit: goes without --rate"));
  std::filesystem::create_directories("a_folder");
  written("a.bin", "");
  for (const auto& option : {Words{"--column", "2"}, Words{"--time-column", "t"}, Words{"--rate", "2000"},
                             Words{"--time-unit", "s"}, Words{"--deceleration-unit", "g"}}) {
    REQUIRE(refusal("a_folder", option) == option[0] + ": needs a table, and FILE is the folder of a drop");
    REQUIRE(refusal("a.bin", option) == option[0] + ": needs a table, and FILE is a BlueDrop's record");
  }
  REQUIRE(of(table, {"--scale", "2g=1"}) == "--scale: needs a BlueDrop's record (.bin), and FILE is a table");
}

namespace {

/// How an accelerometer shows a net record.
std::vector<double> shown_by(std::vector<double> net, double sign, bool proper, double offset) {
  for (double& a : net) a = sign * (a + (proper ? 1 : 0) + offset);
  return net;
}

std::string file_of(const std::vector<double>& values, double rate = 2000) {
  return written("record.csv", Form{}.table(values, rate));
}

bool warns(const Reduction& r, const std::string& part) {
  return std::ranges::any_of(r.warnings, [&](const std::string& text) { return holds(text, part); });
}

}  // namespace

TEST_CASE("sign, 1 g at rest and an offset are recognised, and reported or taken out") {
  const Fall whole;
  for (const Fall& motion :
       {whole, Fall{.before = 0}, Fall{.after = 0.1}, Fall{.before = 0.12, .after = 0.12},
        Fall{.fall = 0.2, .braking = 0.02, .peak = 0.2 * pi / 2 / 0.02}}) {
    const auto net = motion.record();
    const double exact = motion.depth();
    for (const double sign : {1.0, -1.0})
      for (const bool proper : {false, true}) {
        std::vector<std::string> words;
        std::string advice;
        if (proper) words = {"--reads", "proper"}, advice = "give --reads proper";
        if (sign < 0) words.push_back("--invert"), advice += proper ? " and --invert" : "give --invert";
        for (const double offset : {0.0, 0.05, -0.05}) {
          CAPTURE(motion.before, motion.after, sign, proper, offset);
          const auto file = file_of(shown_by(net, sign, proper, offset));
          if (!words.empty()) {
            REQUIRE(holds(refusal(file), "; " + advice));
            if (!(sign < 0 && proper)) {  // else nothing in it slows
              const auto forced = reduced(
                  file, {"--impact-time", exactly(motion.before + motion.fall), "--impact-velocity", "5"});
              REQUIRE(warns(forced, advice));
              std::ostringstream table;
              print_table(forced, ReduceOptions{}, table);
              REQUIRE(holds(table.str(), advice));
              REQUIRE(holds(json_of(forced, ReduceOptions{})["warnings"][0], advice));
            }
          }
          const auto read = reduced(file, words), taken = reduced(file, joined(words, {"--zero-at-rest"}));
          REQUIRE(std::abs(*read.levels.offset() - offset) < 1e-4);
          REQUIRE(std::abs(taken.taken_off / g - offset) < 1e-4);
          REQUIRE(std::abs(taken.greatest_depth / exact - 1) < 0.025);  // 2 kHz, and a threshold
          REQUIRE(taken.warnings.empty());
          REQUIRE(std::abs(*read.depth_without_offset / taken.greatest_depth - 1) < 1e-9);
          const bool matters = std::abs(read.greatest_depth / taken.greatest_depth - 1) > 0.02;
          if (offset == 0) REQUIRE(!matters);
          REQUIRE(warns(read, "with that taken off (--zero-at-rest) the depth is") == matters);
          REQUIRE(read.warnings.empty() == !matters);
        }
      }
  }
  // 0.05 g are a tenth of the depth.
  const auto off = reduced(file_of(shown_by(whole.record(), 1, false, -0.05)));
  REQUIRE(std::abs(off.greatest_depth / whole.depth() - 1) > 0.08);
  REQUIRE(off.warnings.size() == 1);
}

TEST_CASE("options that turn a good record are named, to be left out") {
  const auto file = file_of(Fall{}.record());
  REQUIRE(holds(refusal(file, {"--invert"}),
                "0 g before the release, -1 g in the fall, 0 g after the end; leave out --invert"));
  REQUIRE(holds(refusal(file, {"--reads", "proper"}), "; give --reads net"));
  REQUIRE(holds(refusal(file, {"--reads", "proper", "--invert", "--zero-at-rest"}),
                "; leave out --invert; give --reads net"));
  REQUIRE(holds(refusal(file, {"--deceleration-unit", "m_s2"}), "; give --deceleration-unit g"));
  std::vector<double> in_m_s2;
  for (const double a : shown_by(Fall{}.record(), -1, true, 0)) in_m_s2.push_back(a * g);
  REQUIRE(
      holds(refusal(file_of(in_m_s2)), "; give --deceleration-unit m_s2 and --reads proper and --invert"));
  REQUIRE(holds(refusal(file_of(Fall{}.record()), {"--time-unit", "ms"}),
                "are these units and sign (--invert) of the record?"));
  REQUIRE(holds(refusal(file_of(Fall{}.record(), 2)), "must be at most 100 m/s; is the unit of the time"));
}

TEST_CASE("records that show little") {
  const Fall motion{.before = 0, .after = 0};
  const auto cut = motion.record();
  const auto file = file_of({cut.begin() + 800, cut.end() - 20});  // 0.1 s of fall, and a part of the braking
  const auto given = reduced(file, {"--impact-velocity", "4.905"});
  REQUIRE((!given.levels.before && !given.levels.after && !given.depth_without_offset));
  REQUIRE(std::abs(*given.levels.fall + 1) < 1e-6);
  REQUIRE(given.warnings.empty());
  REQUIRE(holds(refusal(file), "give --impact-velocity"));
  REQUIRE(holds(refusal(file, {"--impact-velocity", "4.905", "--zero-at-rest"}), "shows no quiet rest"));
  const auto proper = file_of(shown_by({cut.begin() + 800, cut.end() - 20}, -1, true, 0));
  REQUIRE(holds(refusal(proper, {"--impact-velocity", "4.905"}), "give --reads proper and --invert"));
  // Only the braking.
  const auto braking =
      reduced(file_of({cut.end() - 92, cut.end()}), {"--impact-time", "0", "--impact-velocity", "4.905"});
  REQUIRE((!braking.levels.before && !braking.levels.fall));
  REQUIRE(braking.warnings.empty());
  REQUIRE(std::abs(braking.greatest_depth / motion.depth() - 1) < 0.01);
}

TEST_CASE("in water, where the fall is not free") {
  std::vector<double> net;
  double velocity = 0;
  for (int i = 0; i < 5200; ++i) {
    const double t = i / 2000. - 0.5;
    const double a = t < 0 ? 0 : t < 1.5 ? -0.6 * std::exp(-2 * t) : 0;
    velocity -= a * g / 2000;
    net.push_back(a);
  }
  const double braking = 0.05, peak = velocity * pi / 2 / braking / g;
  for (int i = 0; i < 100; ++i) net[static_cast<std::size_t>(4000 + i)] = peak * std::sin(pi * i / 100);
  for (const double offset : {0.0, 0.04}) {
    const auto file = file_of(shown_by(net, -1, true, offset));
    REQUIRE(holds(refusal(file, {"--medium", "water"}), "give --reads proper and --invert"));
    const auto r = reduced(file, {"--medium", "water", "--reads", "proper", "--invert"});
    REQUIRE(std::abs(*r.levels.before - offset) < 1e-4);
    REQUIRE(std::abs(*r.depth_without_offset / (velocity * braking / 2) - 1) < 0.05);
    REQUIRE(r.warnings.empty() == (offset == 0));
  }
}

TEST_CASE("noise and resolution are no reason to warn") {
  const auto net = Fall{}.record();
  for (const double resolution : {1e-6, 0.01, 0.1})
    for (const double noise : {0.0, 0.02, 0.1}) {
      CAPTURE(resolution, noise);
      auto record = net;
      unsigned seed = 1;
      for (double& a : record) {
        double sum = 0;  // nearly normal
        for (int i = 0; i < 12; ++i)
          sum += static_cast<double>((seed = seed * 1664525u + 1013904223u) >> 8) / (1 << 24) - 0.5;
        a = std::round((a + noise * sum) / resolution) * resolution;
      }
      for (const std::ptrdiff_t from : {0, 900}) {  // with the release, and in the fall
        const auto r = reduced(file_of({record.begin() + from, record.end()}));
        CAPTURE(from, r.warnings);
        REQUIRE(r.motion.velocity_from == (from == 0 ? "release" : "rest"));
        REQUIRE(r.warnings.empty());
        REQUIRE(std::abs(r.greatest_depth / Fall{}.depth() - 1) < 0.03);
        REQUIRE(std::abs(*r.motion.stop / 0.046 - 1) < 0.2);
      }
    }
  auto fine = Fall{}.record(10000);  // whose top is flat for 20 samples
  for (double& a : fine) a = std::round(a / 0.1) * 0.1;
  REQUIRE(reduced(file_of(fine, 10000)).warnings.empty());
}

TEST_CASE("what a record cannot show is said") {
  const auto net = Fall{}.record();
  auto clipped = net;
  for (double& a : clipped) a = std::min(a, 12.0);
  REQUIRE(warns(reduced(file_of(clipped)), "stays at its largest, 12 g, for"));
  for (const int missing : {1, 30}) {
    auto rows = Form{}.table(net);
    std::size_t from = 0;
    for (int line = 0; line < 1830; ++line) from = rows.find('\n', from) + 1;
    std::size_t to = from;
    for (int line = 0; line < missing; ++line) to = rows.find('\n', to) + 1;
    const auto r = reduced(written("gap.csv", rows.erase(from, to - from)));
    REQUIRE(warns(r, joined_text({"has a gap of ", missing == 1 ? "1" : "15.5", " ms at 0.914"})));
  }
  REQUIRE(warns(reduced(file_of(Fall{}.record(150), 150)), "samples between impact and rest, too few"));
  auto leaning = net;
  for (std::size_t i = 1900; i < leaning.size(); ++i) leaning[i] -= 0.08;
  REQUIRE(
      warns(reduced(file_of(leaning)), "the rests differ: 0 g before the release, -0.08 g after the end"));
  auto scaled = net;
  for (double& a : scaled) a *= 0.95;
  REQUIRE(warns(reduced(file_of(scaled)), "changes by 0.95 g, in free fall by 1 g"));
  for (double& a : scaled) a *= 0.5;
  REQUIRE(holds(refusal(file_of(scaled)),
                "-0.475 g in the fall, 0 g after the end; a net record reads 0, -1 and 0"));
  REQUIRE(
      warns(reduced("record.csv", {"--threshold", "-0.4"}), "are unit, scale, --gravity and --medium those"));
  const Fall lost{.peak = 0.9 * 0.5 * pi / 2 / 0.046};
  REQUIRE(warns(reduced(file_of(lost.record())), "the integral leaves"));
}

namespace {

/// Two records one after the other.
std::vector<double> both(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Half a sine of `peak` g for `braking` s from the sample at `from` s on.
std::vector<double> knocked(std::vector<double> net, double from, double braking, double peak) {
  for (std::size_t i = 0; i < net.size(); ++i)
    if (const double t = static_cast<double>(i) / 2000 - from; t > 0 && t < braking)
      net[i] = peak * std::sin(pi * t / braking);
  return net;
}

}  // namespace

TEST_CASE("a slow logger finds the impact, and says how far off it may be") {
  const Fall motion;
  for (const double rate : {100.0, 200.0, 250.0, 400.0, 500.0, 1000.0})
    for (const double shift : {0.0, 0.25, 0.5, 0.75}) {  // of a sample
      Fall shifted = motion;
      shifted.before += shift / rate;
      const auto r = reduced(file_of(shifted.record(rate), rate));
      CAPTURE(rate, shift, r.greatest_depth, *r.depth_of_sampling);
      const double sample = motion.velocity() / rate;
      REQUIRE(*r.depth_of_sampling < 1.01 * (rate < 500 ? sample / 2 : sample));
      REQUIRE(*r.depth_of_sampling > 0.48 * sample);
      REQUIRE(std::abs(r.greatest_depth - motion.depth()) < *r.depth_of_sampling + 5e-4);
      REQUIRE(std::abs(r.motion.impact_velocity / motion.velocity() - 1) < (rate < 200 ? 0.04 : 0.02));
      if (rate < 300 || rate > 900) REQUIRE(warns(r, "between two samples") == (rate < 300));
    }
}

TEST_CASE("several drops in a record are listed, and one is chosen by its number or its time") {
  const Fall first, second{.before = 2, .fall = 0.3, .braking = 0.02, .peak = 0.3 * pi / 2 / 0.02};
  const auto file = file_of(both(first.record(), second.record()));
  const std::string list =
      "\n  drop 1 at 0.8996 s (4.9 m/s, 0.115 m, 17.1 g)\n  drop 2 at 3.7461 s (2.94 m/s, 0.0306 m, 23.5 g)";
  REQUIRE(refusal(file) == "record.csv: holds 2 drops; give --drop N, or --impact-time:" + list);
  std::vector<double> many;
  for (int k = 0; k < 14; ++k) many = both(many, second.record());  // none is left out of the list
  REQUIRE(holds(refusal(file_of(many)), "\n  drop 14 at 38.9596 s (2.94 m/s"));
  file_of(both(first.record(), second.record()));
  for (const auto& [words, motion] : {std::pair{std::vector<std::string>{"--drop", "1"}, first},
                                      {{"--drop", "2"}, second},
                                      {{"--impact-time", "0.9"}, first},
                                      {{"--impact-time", "3.746"}, second}}) {
    const auto r = reduced(file, words);
    CAPTURE(words);
    REQUIRE(std::abs(r.motion.impact_velocity / motion.velocity() - 1) < 0.01);
    REQUIRE(std::abs(r.greatest_depth / motion.depth() - 1) < 0.06);
    REQUIRE(std::abs(r.peak_g() / motion.peak - 1) < 0.01);
    const auto events = json_of(r, ReduceOptions{})["events"];
    REQUIRE(events.size() == 2);
    REQUIRE(std::abs(events[1]["time_s"].get<double>() - 3.746) < 1e-3);
    REQUIRE(std::abs(events[1]["velocity_m_s"].get<double>() / second.velocity() - 1) < 0.01);
    REQUIRE(std::abs(events[1]["depth_cm"].get<double>() / second.depth() / 100 - 1) < 0.06);
    REQUIRE(std::abs(events[1]["peak_g"].get<double>() / second.peak - 1) < 0.01);
  }
  REQUIRE(holds(refusal(file, {"--drop", "3"}), "--drop = 3: the record holds 2 drops:" + list));
  REQUIRE(holds(refusal(file, {"--drop", "1", "--impact-time", "1"}), "--drop = 1: goes without"));
}

TEST_CASE("knocks and glitches beside a drop change nothing, and are reported by time") {
  const Fall motion{.after = 2};
  const auto net = motion.record();
  const double depth = reduced(file_of(net)).greatest_depth;
  for (const double at : {0.1, 0.2, 1.9}) {
    for (const std::vector<double>& record :
         {knocked(net, at, 5e-3, 2 * motion.peak), knocked(net, at, 5e-4 * 1.5, 250)}) {
      const auto r = reduced(file_of(record));
      CAPTURE(at, r.notes);
      REQUIRE(std::abs(r.greatest_depth - depth) < 1e-12);
      REQUIRE(r.warnings.empty());
      REQUIRE(r.events.size() == 2);
      REQUIRE(holds(r.notes.back() + r.notes[1] + r.notes[0], joined_text({" at ", at})));
    }
  }
  auto glitch = net;
  glitch[1400] = -250;  // in the fall
  const auto r = reduced(file_of(glitch));
  REQUIRE(warns(r, "-250 g at 0.7 s; without them the impact has 4.9 m/s"));
  REQUIRE(warns(r, "the integral leaves 1.2"));
  // With another reading, too.
  REQUIRE(
      holds(refusal(file_of(shown_by(knocked(net, 0.2, 5e-3, 40), 1, true, 0))), "; give --reads proper"));
}

TEST_CASE("the impact is the first contact after the fall, be it a crust over a void; in water the ground") {
  auto net = Fall{.braking = 0, .after = 0}.record();
  std::vector<double> crust = net, water{};
  const auto add = [](std::vector<double>& to, double seconds, auto&& a) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 2000)); ++i) to.push_back(a(i / 2000.));
  };
  const auto sine = [](double peak, double braking) {
    return [=](double t) { return peak * std::sin(pi * t / braking); };
  };
  const auto level = [](double a) { return [=](double) { return a; }; };
  double left = 0.5 - 10 * 0.02 * 2 / pi + 0.95 * 0.03;  // s of fall
  add(crust, 0.02, sine(10, 0.02));
  add(crust, 0.03, level(-0.95));
  add(crust, 0.03, sine(left * pi / 2 / 0.03, 0.03));
  add(crust, 1, level(0));
  const auto r = reduced(file_of(crust));
  REQUIRE(std::abs(r.motion.impact_velocity - 4.905) < 0.01);
  REQUIRE(std::abs(r.greatest_depth - 0.26018) < 3e-3);
  REQUIRE(std::abs(r.peak_g() / (left * pi / 2 / 0.03) - 1) < 0.01);
  REQUIRE(r.warnings.empty());
  // Through a metre of water.
  water.assign(1000, 0);
  add(water, 0.3, level(-1));
  add(water, 0.01, sine(8, 0.01));
  add(water, 1, level(-0.05));
  left = 0.3 - 8 * 0.01 * 2 / pi + 0.05;
  add(water, 0.12, sine(left * pi / 2 / 0.12, 0.12));
  add(water, 1, level(0));
  const auto file = file_of(water);
  const auto ground = reduced(file, {"--medium", "water"});
  REQUIRE(std::abs(ground.motion.impact_velocity - left * g) < 0.03);
  REQUIRE(std::abs(ground.greatest_depth / (left * g * 0.06) - 1) < 0.1);
  REQUIRE(holds(refusal(file), "no drop moves so: "));
  REQUIRE(holds(refusal(file), "it goes 2.8"));
  REQUIRE(warns(reduced(file, {"--force"}), "no drop moves so: "));
}

TEST_CASE("an accelerometer without a constant level is refused") {
  const auto net = Fall{}.record();
  for (const double tau : {0.5, 2.0}) {
    std::vector<double> coupled{net[0]};
    for (std::size_t i = 1; i < net.size(); ++i)
      coupled.push_back(tau / (tau + 5e-4) * (coupled.back() + net[i] - net[i - 1]));
    REQUIRE(holds(refusal(file_of(coupled)), "does the accelerometer hold a level (an AC-coupled one"));
  }
  const Fall lost{.peak = 0.4 * 0.5 * pi / 2 / 0.046};
  REQUIRE(holds(refusal(file_of(lost.record())), "the integral leaves 2.9"));
  auto clipped = Fall{}.record();
  for (std::size_t i = 0; i < clipped.size(); ++i)
    clipped[i] = std::min(clipped[i], 9.5) + (i % 3 == 0 ? 0.01 : i % 5 == 0 ? -0.01 : 0);
  REQUIRE(warns(reduced(file_of(clipped)), "stays at its largest, 9.5"));
}
