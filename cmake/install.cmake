# What `cmake --install` puts under the prefix: the program, what it looks for beside itself, and the Python package,
# which looks for the program beside itself.
if(TARGET kreisel)
  install(TARGETS kreisel)
  install(DIRECTORY experiments DESTINATION share/kreisel FILES_MATCHING PATTERN "*.json" PATTERN "published.csv")
  install(DIRECTORY plots/gnuplot/ DESTINATION share/kreisel/plots FILES_MATCHING PATTERN "*.gp")
  install(DIRECTORY python/kreisel DESTINATION share/kreisel/python FILES_MATCHING PATTERN "*.py")
  install(CODE [[message(STATUS "For Python: export PYTHONPATH=${CMAKE_INSTALL_PREFIX}/share/kreisel/python")]])
endif()
