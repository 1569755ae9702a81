# desmo_linked_documents(RESULT FILE...): sets RESULT to these files of the source tree and all
# files that they link to, directly or not. So links of installed documents work, and nothing else
# of the tree is installed.
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

# desmo_links(RESULT FILE): sets RESULT to the targets of a Markdown file's relative links, as paths
# from the source tree; to nothing for any other file.
function(desmo_links result document)
  set(targets "")
  if(document MATCHES "\\.md$")
    cmake_path(GET document PARENT_PATH folder)
    file(READ ${PROJECT_SOURCE_DIR}/${document} text)
    string(REGEX REPLACE "\\]\\(|(src|href)=\"" "\nlink " text "${text}")
    string(REGEX REPLACE "[][;]" " " text "${text}")  # these divide or join elements of a list
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
