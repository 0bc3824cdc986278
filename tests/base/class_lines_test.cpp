// The scanner of the architecture test that counts the lines of classes.
#include "class_lines.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gapcheck::architecture_test {
namespace {

using enum Definition::Kind;

/// As in the library; the number of a line is written where it matters.
const std::string header = R"(#pragma once
#define BRACE {
namespace room {
namespace floor {

enum class Kind { none, some };
class Later;

/// A class {with a brace in its comment}.
class Outer final : public Base<Kind> {  // 10
 public:
  explicit Outer(int a) : a_{a} {}
  struct Inner {
    int value = 0;
  };
  template <class T>
  void each(T f) const {
    for (int i : list_) f(i);
  }

 private:
  int a_;
};  // 23

template <class T, class U>
struct Pair {
  T first{};
  U second{};
};

inline constexpr int table[] = {1, 2};
template <class T>
bool free_function(const T& outer) {
  return outer.ok();
}

}  // namespace floor
}  // namespace room
)";

const std::string body = R"(namespace room::floor {
namespace {
struct Local {
  int value() const;
};
int Local::value() const { return std::max(1, 2); }
std::vector<Outer::Inner> free(const Outer& outer) {
  return {outer.inner()};
}
}  // namespace

Outer::Outer(int a, int b) : a_{a}, b_{b}, c_(std::min(a, b)) {
  call({a, b});
}

template <class T>
std::vector<T> Pair<T, T>::all(const Outer& of) const {
  const char* text = "}";
  return {first, second};
}

bool Outer::Inner::operator()(int x) const { return x == value; }
Outer::~Outer() = default;
const int Outer::constant = std::min(1, 2);
}  // namespace room::floor
)";

TEST(ClassLines, FindsClassesAndMembers) {
  EXPECT_EQ(definitions(code_only(header)),
            (std::vector<Definition>{{class_, "Outer", 10, 23}, {class_, "Inner", 13, 15}, {class_, "Pair", 25, 29}}));
  EXPECT_EQ(definitions(code_only(body)), (std::vector<Definition>{{class_, "Local", 3, 5},
                                                                   {member, "Local", 6, 6},
                                                                   {member, "Outer", 12, 14},
                                                                   {member, "Pair", 16, 20},
                                                                   {member, "Inner", 22, 22}}));
}

Source source(const std::string& path, const std::string& text) {
  Source result = placed(path);
  result.lines = split_lines(text);
  return result;
}

TEST(ClassLines, AddsMembersToTheirClass) {
  const std::vector<ClassLength> lengths = class_lengths({
      source("room/floor/outer.hpp", header),
      source("room/floor/outer.cpp", body),
      source("room/floor/twin.cpp", "namespace room {\nclass Outer {\n};\nvoid Outer::f() {\n}\n}\n"),
      source("room/other/outer.hpp", "namespace other {\nclass Outer {\n};\n}\n"),
      source("room/another/more.cpp", "namespace room {\nvoid Pair::print() {\n}\nvoid Unknown::f() {}\n}\n"),
  });
  std::vector<std::string> found;
  for (const ClassLength& each : lengths)
    found.push_back(each.path + " " + each.name + " " + std::to_string(each.lines));
  EXPECT_EQ(found, (std::vector<std::string>{
                       "room/floor/outer.hpp Outer 17",
                       "room/floor/outer.hpp Inner 4",
                       "room/floor/outer.hpp Pair 12",
                       "room/floor/outer.cpp Local 4",
                       "room/floor/twin.cpp Outer 4",
                       "room/other/outer.hpp Outer 2",
                   }));
}

TEST(ClassLines, LibraryHasClassesWithMembers) {
  std::size_t with_members = 0;
  const std::vector<Source> sources = library_sources();
  for (const Source& each : sources)
    for (const Definition& definition : definitions(code_only(each))) with_members += definition.kind == member;
  EXPECT_GT(with_members, 300U);
}

}  // namespace
}  // namespace gapcheck::architecture_test
