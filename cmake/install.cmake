# What `cmake --install` puts under the prefix: the program, what it looks for beside itself, its man page, the schema
# of configs, completions for shells, and the Python package, which looks for the program beside itself.
if(TARGET kreisel)
  # The program writes its man page and the schema.
  set(shell ${CMAKE_SOURCE_DIR}/driver/shell)
  set(written ${CMAKE_BINARY_DIR}/generated/installed)
  file(MAKE_DIRECTORY ${written})
  string(TIMESTAMP today "%Y-%m-%d" UTC)
  add_custom_command(OUTPUT ${written}/kreisel.1 ${written}/schema.json
                     DEPENDS kreisel ${shell}/manual.sh ${shell}/manual.awk
                     COMMAND ${shell}/manual.sh $<TARGET_FILE:kreisel> ${PROJECT_VERSION} ${today}
                             > ${written}/kreisel.1
                     COMMAND kreisel schema > ${written}/schema.json)
  add_custom_target(kreisel_installed ALL DEPENDS ${written}/kreisel.1 ${written}/schema.json)

  install(TARGETS kreisel)
  install(DIRECTORY experiments DESTINATION share/kreisel FILES_MATCHING
          PATTERN "*.json" PATTERN "*.urdf" PATTERN "*.csv")
  install(DIRECTORY plots/gnuplot/ DESTINATION share/kreisel/plots FILES_MATCHING PATTERN "*.gp")
  install(DIRECTORY python/kreisel DESTINATION share/kreisel/python FILES_MATCHING PATTERN "*.py")
  install(FILES ${written}/schema.json DESTINATION share/kreisel)
  install(FILES ${written}/kreisel.1 DESTINATION share/man/man1)
  install(FILES ${shell}/kreisel.bash DESTINATION share/bash-completion/completions RENAME kreisel)
  install(FILES ${shell}/_kreisel DESTINATION share/zsh/site-functions)
  install(FILES ${shell}/kreisel.fish DESTINATION share/fish/vendor_completions.d)
  install(CODE [[message(STATUS "For Python: export PYTHONPATH=${CMAKE_INSTALL_PREFIX}/share/kreisel/python")]])
endif()
