// SPDX-License-Identifier: GPL-3.0-or-later
#include "arch/source_rules.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <unistd.h>

using namespace agv::arch;
namespace fs = std::filesystem;

namespace {

const fs::path sourceDir = AGV_SOURCE_DIR;
const fs::path badTree = sourceDir / "tests" / "arch" / "fixtures" / "bad_tree";

/// Too long already; to be split when they are touched next. No file is ever added.
const std::set<std::string> awaitingSplit{"tests/simserver/test_simserver.cpp"};

std::string report(const std::vector<Violation>& violations, const std::string& prefix)
{
    std::string text;
    for (const Violation& violation : violations)
        text += prefix + toText(violation) + "\n";
    return text;
}

std::vector<std::string> texts(const std::vector<Violation>& violations)
{
    std::vector<std::string> all;
    for (const Violation& violation : violations)
        all.push_back(toText(violation));
    return all;
}

/// A folder of its own below the system's temporary directory, removed at the end.
class TemporaryFolder {
public:
    TemporaryFolder() : m_path(fs::path(testing::TempDir()) / ("agv_arch_" + std::to_string(::getpid())))
    {
        fs::create_directories(m_path);
    }
    ~TemporaryFolder() { fs::remove_all(m_path); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const fs::path& path() const { return m_path; }
    void write(const std::string& name, std::size_t lines) const
    {
        std::ofstream file(m_path / name);
        file << "// SPDX-License-Identifier: GPL-3.0-or-later\n";
        for (std::size_t i = 1; i < lines; ++i)
            file << "//\n";
    }

private:
    fs::path m_path;
};

} // namespace

TEST(Architecture, holdsForEveryIncludeOfTheProgram)
{
    EXPECT_EQ(report(checkIncludes(sourceDir / "src", moduleRules()), "src/"), "");
}

TEST(Architecture, holdsForEveryFileOfTheProgramAndItsTests)
{
    for (const std::string folder : {"src", "tests"}) {
        auto violations = checkFiles(sourceDir / folder);
        std::erase_if(violations, [&folder](const Violation& violation) {
            return violation.line > maxFileLines && awaitingSplit.contains(folder + "/" + violation.file);
        });
        EXPECT_EQ(report(violations, folder + "/"), "");
    }
}

TEST(Architecture, hasNoCycleBetweenModules)
{
    EXPECT_EQ(findCycle(moduleRules()), std::vector<std::string>{});
}

TEST(Architecture, namesEveryModuleItsRulesMention)
{
    for (const auto& [module, rule] : moduleRules()) {
        EXPECT_FALSE(rule.mayUse.contains(module)) << module;
        for (const std::string& used : rule.mayUse) {
            ASSERT_TRUE(moduleRules().contains(used)) << module << " -> " << used;
            EXPECT_TRUE(rule.qt || !moduleRules().at(used).qt) << module << " gets Qt through " << used;
        }
    }
}

TEST(Architecture, findsACycle)
{
    const ModuleRules rules{
        {"a", {{"b"}, false}}, {"b", {{"c", "d"}, false}}, {"c", {{}, false}}, {"d", {{"b"}, false}}};
    EXPECT_EQ(findCycle(rules), (std::vector<std::string>{"b", "d"}));
}

TEST(Architecture, namesFileAndLineOfEveryForbiddenInclude)
{
    EXPECT_EQ(
        texts(checkIncludes(badTree, moduleRules())),
        (std::vector<std::string>{
            "core/uses_qt.h:4: core is free of Qt and must not include <QString>",
            "core/uses_qt.h:6: core is free of Qt and must not include <qcustomplot.h>",
            "core/uses_qt.h:7: core is free of Qt and must not include <ui_page.h>",
            "core/uses_qt.h:8: core must not include protocol (\"protocol/reader_line.h\")",
            "estimation/relative.cpp:2: \"local.h\" does not name its module; write \"module/header.h\"",
            "estimation/relative.cpp:3: \"../core/ids.h\" does not name its module; write "
            "\"module/header.h\"",
            "estimation/relative.cpp:4: a header of this project is included with quotes: \"core/ids.h\"",
            "estimation/relative.cpp:5: estimation must not include procedure (\"procedure/link_life.h\")",
            "gui/reaches_down.cpp:3: gui must not include session (\"session/session.h\")",
            "gui/reaches_down.cpp:4: includes a whole Qt library, <QtWidgets>; include single class headers",
            "session/moc_trap.h:4: a header that moc reads includes a Qt header before anything else",
            "wheel/unknown.h:1: is in no module of the include rule",
        }));
}

TEST(Architecture, namesEveryFileWithoutLicenceOrGuardAndEveryOddName)
{
    const std::string licence = "does not begin with \"// SPDX-License-Identifier: GPL-3.0-or-later\"";
    EXPECT_EQ(texts(checkFiles(badTree)), (std::vector<std::string>{
                                              "protocol/CamelCase.cpp:1: is not named in snake_case",
                                              "protocol/no_guard.h:1: is a header without #pragma once",
                                              "protocol/no_licence.cpp:1: " + licence,
                                          }));
}

TEST(Architecture, acceptsAFileOfFullLengthAndNamesAFileOneLineLonger)
{
    const TemporaryFolder folder;
    folder.write("full.cpp", maxFileLines);
    EXPECT_EQ(texts(checkFiles(folder.path())), std::vector<std::string>{});
    folder.write("longer.cpp", maxFileLines + 1);
    EXPECT_EQ(texts(checkFiles(folder.path())),
              std::vector<std::string>{"longer.cpp:401: has 401 lines, more than 400; split it"});
}

TEST(Architecture, doesNotTakeAMissingTreeForACleanOne)
{
    EXPECT_THROW(checkFiles(sourceDir / "no such folder"), fs::filesystem_error);
}
