// gles1.def against the Khronos registry: every listed call exists there, every core command is
// listed, and each is found by name.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "api/context.h"

namespace clearpipe::api {
namespace {

const std::set<std::string> kCommonLite = {
#define CORE(name) #name,
#define COMMON(name)
#define EXTENSION(name)
#include "api/registry_names.def"
#undef CORE
#undef COMMON
#undef EXTENSION
};
// With those of the Common profile alone.
const std::set<std::string> kCore = {
#define CORE(name) #name,
#define COMMON(name) #name,
#define EXTENSION(name)
#include "api/registry_names.def"
#undef CORE
#undef COMMON
#undef EXTENSION
};
const std::set<std::string> kExtension = {
#define CORE(name)
#define COMMON(name)
#define EXTENSION(name) #name,
#include "api/registry_names.def"
#undef CORE
#undef COMMON
#undef EXTENSION
};
const std::vector<std::string> kListed = {
#define CALL(type, name, parameters, arguments, validator, executor, group, stages) "gl" #name,
#include "api/gles1.def"
#undef CALL
};
const std::set<std::string> kListedWithFloats = {
#define CALL(...)
#define COMMON_CALL(type, name, ...) "gl" #name,
#include "api/gles1.def"
#undef CALL
};
// What the calls take, as text.
const std::map<std::string, std::string> kParameters = {
#define CALL(type, name, parameters, ...) {"gl" #name, #parameters},
#include "api/gles1.def"
#undef CALL
};
// Second names, and the commands that they name.
const std::map<std::string, std::string> kAliases = {
#define ALIAS(name, command) {"gl" #name, "gl" #command},
#include "api/gles1_aliases.def"
#undef ALIAS
};

TEST(Registry, EveryAliasIsACommandOfAnExtension) {
  const std::set<std::string> listed(kListed.begin(), kListed.end());
  for (const auto& [name, command] : kAliases) {
    EXPECT_TRUE(kExtension.count(name)) << name;
    EXPECT_FALSE(listed.count(name)) << name;
    EXPECT_TRUE(listed.count(command)) << command;
    EXPECT_EQ(proc_address(name.c_str()), proc_address(command.c_str())) << name;
  }
}

TEST(Registry, EveryListedCallIsACommandOfOpenGlEs1) {
  for (const std::string& name : kListed) {
    EXPECT_TRUE(kCore.count(name) + kExtension.count(name) == 1) << name;
  }
}

TEST(Registry, EveryCoreCommandIsListedOnce) {
  const std::set<std::string> listed(kListed.begin(), kListed.end());
  EXPECT_EQ(listed.size(), kListed.size());
  for (const std::string& name : kCore) EXPECT_TRUE(listed.count(name)) << name;
}

TEST(Registry, CallsWithFloatsAreOfTheCommonProfileAlone) {
  EXPECT_EQ(kCore.size(), 144u);
  EXPECT_EQ(kCommonLite.size(), 106u);
  for (const std::string& name : kListed) {
    const bool floats = kParameters.at(name).find("GLfloat") != std::string::npos &&
                        name != "glSampleCoverage";  // see gles1.def
    EXPECT_EQ(kListedWithFloats.count(name) != 0, floats) << name;
    if (kCore.count(name) != 0) {
      EXPECT_EQ(kCommonLite.count(name) == 0, floats) << name;
    }
  }
}

TEST(Registry, EveryListedCallHasAnAddressOfItsOwn) {
  std::set<Proc> addresses;
  for (const std::string& name : kListed) {
    const Proc proc = proc_address(name.c_str());
    EXPECT_NE(proc, nullptr) << name;
    EXPECT_TRUE(addresses.insert(proc).second) << name;
  }
  EXPECT_EQ(proc_address("glNoSuchCall"), nullptr);
  EXPECT_EQ(proc_address(nullptr), nullptr);
}

}  // namespace
}  // namespace clearpipe::api
