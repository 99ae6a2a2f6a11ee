# The library's sources: every .cpp of a room that rooms.txt names, and nothing else. Its public headers: the doors.
file(STRINGS src/ripstop/rooms.txt lines REGEX "^[a-z_/]+ :")
set(ripstop_sources "")
set(ripstop_doors "")
foreach(line IN LISTS lines)
    string(REGEX MATCH "^([a-z_/]+) :[^|]*\\|([^|]*)" matched "${line}")
    set(room "${CMAKE_MATCH_1}")
    string(REGEX MATCHALL "[a-z0-9_]+\\.h" doors "${CMAKE_MATCH_2}")
    file(GLOB sources CONFIGURE_DEPENDS src/ripstop/${room}/*.cpp)
    list(APPEND ripstop_sources ${sources})
    # A room is one unit of a unity build: names of its unnamed namespaces need to differ within the room alone, and a
    # new file compiles its own room anew and no other.
    string(REPLACE "/" "_" group "${room}")
    set_source_files_properties(${sources} PROPERTIES UNITY_GROUP ${group})
    list(TRANSFORM doors PREPEND ${room}/)
    list(APPEND ripstop_doors ${doors})
endforeach()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS src/ripstop/rooms.txt)
