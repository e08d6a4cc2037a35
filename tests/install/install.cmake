# Installs the build tree `build` into a prefix of its own and moves the tree to `prefix`, empty before: nothing may remember where it was.
file(REMOVE_RECURSE ${prefix} ${prefix}_first)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${build} --prefix ${prefix}_first COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${prefix}_first ${prefix})
