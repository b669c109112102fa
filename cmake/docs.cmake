# The guide in docs/: its links, its commands, which are run as they stand there, and the site that tools/docs makes of
# it; the index of reports. What needs packages beyond those of the tests is left out by name where these are missing, unless KREISEL_REQUIRE
# has their purpose.
set(docs_tests ${CMAKE_SOURCE_DIR}/tests/docs)
add_test(NAME docs.links COMMAND /usr/bin/python3 ${docs_tests}/check_links.py)
add_test(NAME docs.controls COMMAND /usr/bin/python3 ${docs_tests}/controls.py)
add_test(NAME docs.index COMMAND /usr/bin/python3 ${docs_tests}/report_index.py)
set_tests_properties(docs.links docs.controls docs.index PROPERTIES LABELS docs)
if(KREISEL_BINARY128)
  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  add_test(NAME docs.blocks COMMAND /usr/bin/python3 ${docs_tests}/run_blocks.py $<TARGET_FILE:kreisel>
                                    -I ${CMAKE_BINARY_DIR}/generated -I ${eigen})
  set_tests_properties(docs.blocks PROPERTIES LABELS docs TIMEOUT 600 ENVIRONMENT "CXX=${CMAKE_CXX_COMPILER}")
  add_test(NAME docs.site COMMAND /usr/bin/python3 ${docs_tests}/check_site.py $<TARGET_FILE:kreisel>)
  set_tests_properties(docs.site PROPERTIES LABELS docs SKIP_RETURN_CODE 77 TIMEOUT 300)
endif()

# The program as it is installed: what it finds beside itself, man page, completions. What needs a shell or a library
# that is missing is skipped by name.
if(KREISEL_BINARY128)
  add_test(NAME installed COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tests/installed/run.py ${CMAKE_BINARY_DIR})
  set_tests_properties(installed PROPERTIES LABELS installed TIMEOUT 300)
endif()
