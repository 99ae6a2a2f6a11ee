# The library's sources: every .cpp on a floor that layers.txt names, and nothing else.
file(STRINGS src/ripstop/layers.txt lines REGEX "^[a-z_]+:")
set(ripstop_sources "")
foreach(line IN LISTS lines)
    string(REGEX REPLACE ":.*" "" floor "${line}")
    file(GLOB sources CONFIGURE_DEPENDS src/ripstop/${floor}/*.cpp)
    list(APPEND ripstop_sources ${sources})
endforeach()
