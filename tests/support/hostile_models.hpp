#pragma once
/// @file  Files made to hurt the model compiler, each about as large as a file may be. All of them are to be refused.

#include <string>
#include <vector>

namespace articam::test {

struct HostileModel {
  const char* name;
  std::string urdf;
  std::string markers{};  ///< a markers file; empty: none is given
};

/// The part between head and tail as often as it fits into 1 MiB.
inline std::string repeated(const std::string& head, const std::string& part, const std::string& tail) {
  constexpr std::size_t kMebibyte = 1u << 20;
  std::string text = head;
  while (text.size() + part.size() + tail.size() < kMebibyte) text += part;
  return text + tail;
}

/// Links in a chain whose joints mimic the next one, the last the first: every chain is as long as can be.
inline std::string mimic_cycle() {
  std::string text = "<robot name='r'><link name='l0'/>";
  for (int i = 0; i < 255; ++i) {
    const std::string n = std::to_string(i), next = std::to_string((i + 1) % 255), child = std::to_string(i + 1);
    text += "<link name='l" + child + "'/><joint name='j" + n + "' type='continuous'><parent link='l" + n +
            "'/><child link='l" + child + "'/><mimic joint='j" + next + "'/></joint>";
  }
  return text + "</robot>";
}

inline std::string many_attributes() {
  std::string text = "<robot";
  while (text.size() < 1'000'000) text += " a" + std::to_string(text.size()) + "=''";
  return text + "/>";
}

inline std::vector<HostileModel> hostile_models() {
  const std::string fine = "<robot name='r'><link name='l'/></robot>";
  return {{"deep", repeated("<robot name='r'>", "<a>", "")},
          {"wide", repeated("<robot name='r'>", "<joint/>", "</robot>")},
          {"many_links", repeated("<robot name='r'>", "<link name='l'/>", "</robot>")},
          {"same_attributes", repeated("<robot", " a=''", "/>")},
          {"many_attributes", many_attributes()},
          {"long_name", repeated("<robot name='r'><link name='", "x", "'/></robot>")},
          {"comments", repeated("<robot name='r'>", "<!---->", "<link/></robot>")},
          {"instructions", repeated("<robot name='r'>", "<?a?>", "<link/></robot>")},
          {"entities", "<!DOCTYPE r [<!ENTITY a '&b;&b;'><!ENTITY b 'lol'>]><robot name='&a;'/>"},
          {"mimic_cycle", mimic_cycle()},
          {"too_large", std::string(3'000'000, ' ')},
          {"yaml_lists", fine, std::string(1'000'000, '[')},
          {"yaml_deep", fine, "markers: " + std::string(60'000, '[')},
          {"yaml_aliases", fine,
           "a: &a [x,x,x,x,x,x,x,x]\nb: &b [*a,*a,*a,*a,*a,*a,*a]\nc: &c [*b,*b,*b,*b,*b,*b]\n"
           "markers: [*c,*c,*c,*c,*c]\n"},
          {"yaml_many", fine, repeated("markers:\n", "  - {frame: l}\n", "")}};
}

}  // namespace articam::test
