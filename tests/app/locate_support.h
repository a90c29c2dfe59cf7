// SPDX-License-Identifier: GPL-3.0-or-later
// Runs locate and fuse on texts and reads back what they write.
#pragma once

#include "app/locate.h"
#include "core/text_file.h"
#include "recording/csv_table.h"

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace agv::app {

namespace fs = std::filesystem;

inline const std::string uwb = std::string(AGV_TEST_DATA) + "/uwb/";

struct Answer {
    int status = -1;
    std::string out;
    std::string err;
};

inline Answer run(const LocateArguments& arguments, const std::string& input = {})
{
    std::istringstream in(input);
    std::ostringstream out;
    std::ostringstream err;
    const int status = runLocate(arguments, in, out, err);
    return {status, out.str(), err.str()};
}

inline LocateArguments argumentsFor(std::vector<std::string> inputs)
{
    LocateArguments arguments;
    arguments.inputs = std::move(inputs);
    arguments.anchorsFile = uwb + "anchors.csv";
    return arguments;
}

/// Rows of a CSV text by column name.
inline std::vector<std::map<std::string, std::string>> rowsOf(const std::string& text)
{
    std::vector<std::map<std::string, std::string>> rows;
    auto table = recording::CsvTable::open(text);
    EXPECT_TRUE(table) << text;
    while (table && table->next()) {
        rows.emplace_back();
        for (std::size_t i = 0; i < table->header().size(); ++i)
            rows.back()[table->header()[i]] = table->field(i);
    }
    return rows;
}

inline double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

/// Rows of the table of errors by title.
inline std::vector<std::map<std::string, std::string>> errorsOf(const Answer& outcome)
{
    std::string csv = outcome.out.substr(outcome.out.find('\n') + 1); // the line with the units
    csv = std::regex_replace(csv, std::regex(" +"), ",");
    return rowsOf(csv);
}

class LocateFiles : public testing::Test {
protected:
    LocateFiles() { fs::create_directories(folder); }
    ~LocateFiles() override { fs::remove_all(folder); }

    std::string file(const std::string& name, const std::string& text) const
    {
        const auto written = writeTextFile(folder / name, text);
        EXPECT_TRUE(written) << (written ? "" : written.error().detail);
        return (folder / name).string();
    }
    std::string read(const std::string& path) const { return readTextFile(path, 1U << 20U).value_or(""); }

    const fs::path folder = fs::temp_directory_path() / ("agv-locate-" + std::to_string(::getpid()));
};

} // namespace agv::app
