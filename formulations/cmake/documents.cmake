# desmo_linked_documents(RESULT FILE...): these files of the source tree, and every one that they
# link to, directly or not: all that an installed document needs for its links, and nothing else
# that happens to lie in the tree.
function(desmo_linked_documents result)
  set(unread ${ARGN})
  set(documents "")
  while(unread)
    list(POP_FRONT unread document)
    list(APPEND documents ${document})
    desmo_links(links ${document})
    foreach(link IN LISTS links)
      if(NOT link IN_LIST documents AND NOT link IN_LIST unread
          AND EXISTS ${PROJECT_SOURCE_DIR}/${link}
          AND NOT IS_DIRECTORY ${PROJECT_SOURCE_DIR}/${link})
        list(APPEND unread ${link})
      endif()
    endforeach()
  endwhile()
  set(${result} ${documents} PARENT_SCOPE)
endfunction()

# desmo_links(RESULT FILE): where the relative links of a Markdown file point, from the source tree;
# of any other file nothing.
function(desmo_links result document)
  set(targets "")
  if(document MATCHES "\\.md$")
    cmake_path(GET document PARENT_PATH folder)
    file(READ ${PROJECT_SOURCE_DIR}/${document} text)
    string(REGEX REPLACE "\\]\\(|(src|href)=\"" "\nlink " text "${text}")
    string(REGEX REPLACE "[][;]" " " text "${text}")  # would part or join elements of a list
    string(REGEX MATCHALL "\nlink [^:)\"# \n]+[)\"#]" links "${text}")
    foreach(link IN LISTS links)
      string(REGEX REPLACE "^\nlink |[)\"#]$" "" link "${link}")
      cmake_path(APPEND folder ${link} OUTPUT_VARIABLE target)
      cmake_path(NORMAL_PATH target)
      list(APPEND targets ${target})
    endforeach()
  endif()
  set(${result} ${targets} PARENT_SCOPE)
endfunction()
