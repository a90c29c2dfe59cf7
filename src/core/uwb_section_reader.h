// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_file_parts.h"
#include "core/plant_layout.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace agv {

/// Of "dialect" in a plant file: found from what the unit writes.
inline constexpr std::string_view detectedDialect = "detect";

/// Reads the section "uwb" of a plant file whose AGVs and anchors are read already. Use once.
class UwbSectionReader {
public:
    explicit UwbSectionReader(JsonFindings& findings) : m_findings(findings) {}

    void read(JsonFields& root, PlantLayout& plant);

private:
    std::optional<UsbId> readUsbId(JsonFields& fields);
    std::optional<UwbDialect> readDialect(JsonFields& fields);
    void readTag(JsonFields& fields, PlantLayout& plant);
    void readCorrection(JsonFields& fields, PlantLayout& plant);

    JsonFindings& m_findings;
    std::map<int, std::string> m_usedTags;                        ///< id and where it stands
    std::map<std::pair<int, int>, std::string> m_usedCorrections; ///< anchor, tag and where it stands
};

} // namespace agv
