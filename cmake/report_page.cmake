# Embeds report.html, as apps/report builds it, into the library: `report_page_source` defines `page_template`.
# Without Node.js or the npm packages of `make setup`, the template is empty, a message says so, and `flatten`
# writes no report.html.
set(report_page_source ${CMAKE_BINARY_DIR}/generated/report_page.cpp)
set(report_page_app ${CMAKE_SOURCE_DIR}/apps/report)
find_program(RIPSTOP_NODE node)
mark_as_advanced(RIPSTOP_NODE)
set(RIPSTOP_REPORT_FOUND OFF)
if(RIPSTOP_REPORT AND RIPSTOP_NODE AND EXISTS ${report_page_app}/node_modules/vite
   AND EXISTS ${report_page_app}/node_modules/three)
    set(RIPSTOP_REPORT_FOUND ON)
    set(report_page ${CMAKE_BINARY_DIR}/report/index.html)
    file(GLOB_RECURSE report_page_modules CONFIGURE_DEPENDS ${report_page_app}/src/*)
    list(APPEND report_page_modules ${report_page_app}/package.json ${report_page_app}/package-lock.json
         ${report_page_app}/vite.config.js)
    add_custom_command(OUTPUT ${report_page}
        COMMAND ${RIPSTOP_NODE} node_modules/vite/bin/vite.js build
                --outDir ${CMAKE_BINARY_DIR}/report --emptyOutDir --logLevel warn
        WORKING_DIRECTORY ${report_page_app}
        DEPENDS ${report_page_modules} ${report_page_app}/index.html
        COMMENT "Building the page report.html" VERBATIM)
    configure_file(cmake/report_page.cpp.in ${report_page_source} @ONLY)
    set_source_files_properties(${report_page_source} PROPERTIES OBJECT_DEPENDS ${report_page})
else()
    if(RIPSTOP_REPORT)
        message(STATUS "Node.js or the packages of apps/report are missing (make setup installs them): flatten writes no report.html")
    endif()
    configure_file(cmake/no_report_page.cpp.in ${report_page_source} COPYONLY)
endif()
