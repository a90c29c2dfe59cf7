# Installs the build BUILD into the folder PREFIX, which is made anew, and starts the program from there.
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

set(desktop ${PREFIX}/share/applications/agv-console.desktop)
foreach(file ${desktop} ${PREFIX}/share/icons/hicolor/scalable/apps/agv-console.svg
        ${PREFIX}/share/doc/agv-console/LICENSE)
    if(NOT EXISTS ${file})
        message(FATAL_ERROR "${file} was not installed")
    endif()
endforeach()
file(READ ${desktop} entry)
if(NOT entry MATCHES "\nExec=agv-console\n" OR NOT entry MATCHES "\nIcon=agv-console\n")
    message(FATAL_ERROR "${desktop} does not name the program and its icon")
endif()

execute_process(COMMAND ${PREFIX}/bin/agv-console --version OUTPUT_VARIABLE version COMMAND_ERROR_IS_FATAL ANY)
if(NOT version MATCHES "^agv-console [0-9]")
    message(FATAL_ERROR "the installed program says \"${version}\"")
endif()
file(REMOVE_RECURSE ${PREFIX})
