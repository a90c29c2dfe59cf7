// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/uwb/anchor_range.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace agv::estimation {

inline nlohmann::json loadVector(const std::string& name)
{
    std::ifstream file(std::string(AGV_TEST_DATA "/vectors/") + name);
    return nlohmann::json::parse(file);
}

inline Eigen::Vector3d pointOf(const nlohmann::json& p)
{
    return {p.at(0).get<double>(), p.at(1).get<double>(), p.at(2).get<double>()};
}

inline std::vector<Eigen::Vector3d> anchorsOf(const nlohmann::json& c)
{
    std::vector<Eigen::Vector3d> anchors;
    for (const auto& a : c.at("anchors"))
        anchors.push_back(pointOf(a));
    return anchors;
}

/// One range per anchor, in the order of the anchors.
inline std::vector<AnchorRange> rangesFrom(const std::vector<Eigen::Vector3d>& anchors,
                                           const std::vector<double>& ranges, double sd_m)
{
    std::vector<AnchorRange> result;
    for (std::size_t i = 0; i < anchors.size(); ++i)
        result.push_back({anchors[i], ranges[i], sd_m, static_cast<int>(i)});
    return result;
}

/// The room of the thesis, chapter 6, and the one of its conference paper, m.
inline std::vector<Eigen::Vector3d> thesisAnchors() { return {{0, 0, 2}, {4, 0, 2}, {4, 2, 2}, {0, 2, 2.5}}; }
inline std::vector<Eigen::Vector3d> paperAnchors() { return {{0, 0, 2}, {4, 0, 2}, {4, 2, 2}, {0, 2, 0.8}}; }

inline std::vector<double> exactRanges(const std::vector<Eigen::Vector3d>& anchors,
                                       const Eigen::Vector3d& tag)
{
    std::vector<double> ranges;
    for (const auto& anchor : anchors)
        ranges.push_back((tag - anchor).norm());
    return ranges;
}

/// A CSV file by column; empty fields are NaN.
using CsvColumns = std::map<std::string, std::vector<double>>;
inline CsvColumns loadColumns(const std::string& path)
{
    std::ifstream file(path);
    CsvColumns columns;
    std::vector<std::string> names;
    for (std::string line; std::getline(file, line);) {
        std::stringstream fields(line + ",");
        std::size_t i = 0;
        const bool header = names.empty();
        for (std::string field; std::getline(fields, field, ','); ++i) {
            if (!field.empty() && field.back() == '\r')
                field.pop_back();
            if (header)
                names.push_back(field);
            else
                columns[names.at(i)].push_back(field.empty() ? std::numeric_limits<double>::quiet_NaN()
                                                             : std::strtod(field.c_str(), nullptr));
        }
    }
    return columns;
}

} // namespace agv::estimation
