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

const std::set<std::string> kCore = {
#define CORE(name) #name,
#define EXTENSION(name)
#include "api/registry_names.def"
#undef CORE
#undef EXTENSION
};
const std::set<std::string> kExtension = {
#define CORE(name)
#define EXTENSION(name) #name,
#include "api/registry_names.def"
#undef CORE
#undef EXTENSION
};
const std::vector<std::string> kListed = {
#define CALL(type, name, parameters, arguments, validator, executor, group, stages) "gl" #name,
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
