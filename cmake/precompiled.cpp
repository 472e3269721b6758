// What a precompiled header is made with; see Precompiled.cmake.
