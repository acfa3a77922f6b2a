# Joins the parts of the viewer's page, src/io/view, and writes them to OUTPUT as a C++ source. The
# page allows just its own style and script, by their hashes.
#   cmake -DPARTS=src/io/view -DOUTPUT=... -P view_template.cmake
set(base64_digits ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/)

# sha256-... of a text, as a content security policy wants it.
function(hash_of text out)
  string(SHA256 hex "${text}")
  string(APPEND hex "00")  # 33 bytes, of which base64 makes 44 digits; the last one is padding
  set(result "")
  foreach(at RANGE 0 60 6)
    string(SUBSTRING "${hex}" ${at} 6 three_bytes)
    foreach(shift 18 12 6 0)
      math(EXPR digit "(0x${three_bytes} >> ${shift}) & 63")
      string(SUBSTRING "${base64_digits}" ${digit} 1 character)
      string(APPEND result "${character}")
    endforeach()
  endforeach()
  string(SUBSTRING "${result}" 0 43 result)
  set(${out} "sha256-${result}=" PARENT_SCOPE)
endfunction()

function(joined out)
  set(text "\n")
  foreach(name IN LISTS ARGN)
    file(READ "${PARTS}/${name}" part)
    string(APPEND text "${part}")
  endforeach()
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

joined(SCRIPT strict.js data.js fields.js colours.js camera.js state.js scene.js view.js curves.js
  actions.js show.js text.js picture.js input.js main.js)
joined(STYLE page.css)
hash_of("${SCRIPT}" SCRIPT_HASH)
hash_of("${STYLE}" STYLE_HASH)
foreach(shader wire.vert wire.frag screen.vert light.frag blend.frag)
  string(REPLACE "." "_" name "${shader}")
  file(READ "${PARTS}/${shader}.glsl" ${name})
endforeach()
file(READ "${PARTS}/page.html" page)
foreach(name SCRIPT_HASH STYLE_HASH SCRIPT STYLE
    wire_vert wire_frag screen_vert light_frag blend_frag)
  string(REPLACE "@${name}@" "${${name}}" page "${page}")
endforeach()
file(WRITE "${OUTPUT}" "#include \"io/view_template.hpp\"\n\nnamespace wirepack {\n\n"
  "const std::string_view view_template = R\"view_page(${page})view_page\";\n\n"
  "}  // namespace wirepack\n")
