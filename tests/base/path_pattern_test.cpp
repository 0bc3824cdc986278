#include "base/path_pattern.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace gapcheck::path_pattern_test {
namespace {

TEST(PathPattern, NamesStandForThemselves) {
  EXPECT_TRUE(matches("model.k", "model.k"));
  EXPECT_FALSE(matches("model.k", "Model.k"));
  EXPECT_FALSE(matches("model.k", "model.key"));
  EXPECT_FALSE(matches("model.k", "lib/model.k"));
  EXPECT_TRUE(matches("[a].k", "[a].k"));
  EXPECT_FALSE(matches("[a].k", "a.k"));
  EXPECT_TRUE(matches("", ""));
  EXPECT_FALSE(matches("", "a"));
  EXPECT_FALSE(matches("a", ""));
}

TEST(PathPattern, StarStaysInItsFolder) {
  EXPECT_TRUE(matches("lib/*.k", "lib/a.k"));
  EXPECT_TRUE(matches("lib/*.k", "lib/.k"));
  EXPECT_TRUE(matches("*", "a"));
  EXPECT_TRUE(matches("a*b*c", "a--b--b--c"));
  EXPECT_FALSE(matches("a*b*c", "a--c--b"));
  EXPECT_FALSE(matches("lib/*.k", "lib/more/a.k"));
  EXPECT_FALSE(matches("*.k", "lib/a.k"));
  EXPECT_TRUE(matches("*/*.k", "lib/a.k"));
  EXPECT_FALSE(matches("*/*/*.k", "lib/a.k"));
}

TEST(PathPattern, QuestionMarkIsOneCharacter) {
  EXPECT_TRUE(matches("a?.k", "a1.k"));
  EXPECT_FALSE(matches("a?.k", "a.k"));
  EXPECT_FALSE(matches("a?.k", "a12.k"));
  EXPECT_FALSE(matches("a?b", "a/b"));
  EXPECT_TRUE(matches("T?r.k", "T\xC3\xBCr.k"));
  EXPECT_TRUE(matches("T?r.k", "T\xFCr.k"));  // Latin 1: broken UTF-8
  EXPECT_FALSE(matches("T??r.k", "T\xC3\xBCr.k"));
}

TEST(PathPattern, TwoStarsAreAnyFolders) {
  EXPECT_TRUE(matches("**/a.k", "a.k"));
  EXPECT_TRUE(matches("**/a.k", "x/a.k"));
  EXPECT_TRUE(matches("**/a.k", "x/y/a.k"));
  EXPECT_TRUE(matches("**/a.k", "../x/a.k"));
  EXPECT_FALSE(matches("**/a.k", "x/ba.k"));
  EXPECT_TRUE(matches("lib/**/a.k", "lib/a.k"));
  EXPECT_TRUE(matches("lib/**/a.k", "lib/x/y/a.k"));
  EXPECT_FALSE(matches("lib/**/a.k", "x/lib/a.k"));
  EXPECT_TRUE(matches("**/b/**/c/*.k", "b/c/b/d/c/x.k"));
  EXPECT_FALSE(matches("**/b/**/c/*.k", "c/b/x.k"));
}

TEST(PathPattern, TwoStarsAtTheEndAreAllBelow) {
  EXPECT_TRUE(matches("**", "a.k"));
  EXPECT_TRUE(matches("**", "x/y/a.k"));
  EXPECT_TRUE(matches("lib/**", "lib/a.k"));
  EXPECT_TRUE(matches("lib/**", "lib/x/a.k"));
  EXPECT_FALSE(matches("lib/**", "lib"));
  EXPECT_FALSE(matches("lib/**", "library/a.k"));
}

TEST(PathPattern, TwoStarsInANameAreOne) {
  EXPECT_TRUE(matches("a**b", "a-b"));
  EXPECT_FALSE(matches("a**b", "a/b"));
}

/// As the definition says it, exponential.
bool by_definition(std::string_view pattern, std::string_view path) {
  if (pattern == "**") return !path.empty();
  if (pattern.starts_with("**/")) {
    if (by_definition(pattern.substr(3), path)) return true;
    const std::size_t slash = path.find('/');
    return slash != std::string_view::npos && by_definition(pattern, path.substr(slash + 1));
  }
  // Up to the next folder of the pattern.
  if (pattern.empty()) return path.empty();
  if (pattern[0] == '*')
    return by_definition(pattern.substr(1), path) ||
           (!path.empty() && path[0] != '/' && by_definition(pattern, path.substr(1)));
  if (path.empty() || (pattern[0] == '?' ? path[0] == '/' : pattern[0] != path[0])) return false;
  return by_definition(pattern.substr(1), path.substr(1));
}

TEST(PathPattern, AgreesWithItsDefinition) {
  std::mt19937 random(7);
  const std::string_view folders[] = {"**", "*", "a", "b", "a*", "*b", "?", "*a*", "a?b"}, letters = "ab";
  int agreed = 0, matched = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string pattern, path;
    for (auto n = 1 + random() % 4; n > 0; --n)
      (pattern += pattern.empty() ? "" : "/") += folders[random() % std::size(folders)];
    for (auto n = 1 + random() % 4; n > 0; --n) {
      if (!path.empty()) path += '/';
      for (auto m = 1 + random() % 3; m > 0; --m) path += letters[random() % 2];
    }
    const bool expected = by_definition(pattern, path);
    ASSERT_EQ(matches(pattern, path), expected) << pattern << " " << path;
    ++agreed;
    matched += expected ? 1 : 0;
  }
  EXPECT_GT(matched, agreed / 20);
  EXPECT_LT(matched, agreed);
}

TEST(PathPattern, TakesNoExponentialTime) {
  std::string pattern, stars, path;
  for (int i = 0; i < 200; ++i) {
    pattern += "**/*a*/";
    stars += "*a";
    path += "aaaaaaaa/";
  }
  EXPECT_FALSE(matches(pattern + "b", path + "c"));
  EXPECT_FALSE(matches(stars + "b", std::string(4000, 'a')));
  EXPECT_TRUE(matches(stars + "*", std::string(4000, 'a')));
}

}  // namespace
}  // namespace gapcheck::path_pattern_test
