// Nothing but the headers that CMakeLists.txt has precompiled for the test programs.
