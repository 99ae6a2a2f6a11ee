# The library's sources: every .cpp of the rooms that rooms.txt names. Its public headers: the doors.
#
# A unity build compiles each floor as one unit: most of a compiler's time goes into headers and templates, which a unit
# reads once. So names in unnamed namespaces must be unique within a floor.
file(STRINGS src/ripstop/rooms.txt lines REGEX "^[a-z_/]+ :")
set(ripstop_sources "")
set(ripstop_doors "")
foreach(line IN LISTS lines)
    string(REGEX MATCH "^([a-z_/]+) :[^|]*\\|([^|]*)" matched "${line}")
    set(room "${CMAKE_MATCH_1}")
    string(REGEX MATCHALL "[a-z0-9_]+\\.h" doors "${CMAKE_MATCH_2}")
    file(GLOB sources CONFIGURE_DEPENDS src/ripstop/${room}/*.cpp)
    list(APPEND ripstop_sources ${sources})
    string(REGEX REPLACE "/.*" "" floor "${room}")
    set_source_files_properties(${sources} PROPERTIES UNITY_GROUP ${floor})
    list(TRANSFORM doors PREPEND ${room}/)
    list(APPEND ripstop_doors ${doors})
endforeach()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS src/ripstop/rooms.txt)
