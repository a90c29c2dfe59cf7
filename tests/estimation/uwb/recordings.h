// SPDX-License-Identifier: GPL-3.0-or-later
// Real recordings; they are not part of the project. Tests that use them skip themselves where the folder is
// missing; the environment variable AGV_RECORDINGS names another folder.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace agv::estimation {

inline std::filesystem::path recordingsFolder()
{
    const char* other = std::getenv("AGV_RECORDINGS");
    return other != nullptr ? other : AGV_RECORDINGS;
}

/// A row of a CSV file by column name.
class RecordedRow {
public:
    RecordedRow(const std::vector<std::string>& names, const std::string& line)
    {
        std::stringstream fields(line);
        std::size_t i = 0;
        for (std::string field; std::getline(fields, field, ',') && i < names.size(); ++i)
            m_fields[names[i]] = field;
    }
    const std::string& text(const std::string& name) const { return m_fields.at(name); }
    double number(const std::string& name) const { return std::strtod(text(name).c_str(), nullptr); }
    int integer(const std::string& name) const { return static_cast<int>(number(name)); }

private:
    std::map<std::string, std::string> m_fields;
};

inline std::vector<RecordedRow> recordedRows(const std::string& file)
{
    std::ifstream in(recordingsFolder() / file);
    std::vector<RecordedRow> rows;
    std::vector<std::string> names;
    for (std::string line; std::getline(in, line);) {
        while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
            line.pop_back();
        if (!names.empty()) {
            rows.emplace_back(names, line);
            continue;
        }
        std::stringstream fields(line);
        for (std::string field; std::getline(fields, field, ',');)
            names.push_back(field);
    }
    return rows;
}

#define AGV_NEEDS_RECORDING(folder)                                                                          \
    if (!std::filesystem::exists(recordingsFolder() / (folder)))                                             \
    GTEST_SKIP() << "recordings are not here: " << (recordingsFolder() / (folder)).string()

} // namespace agv::estimation
