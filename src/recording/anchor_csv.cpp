// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/anchor_csv.h"

#include "recording/csv_table.h"
#include "recording/csv_text.h"
#include "recording/number_text.h"

#include <array>
#include <cmath>
#include <map>

namespace agv::recording {

namespace {

// As in a plant file.
constexpr double mostCoordinate_m = 1e3;
constexpr int mostId = 255;

class AnchorTable {
public:
    explicit AnchorTable(CsvTable csv) : m_csv(std::move(csv)) {}

    Result<std::vector<UwbAnchor>> read()
    {
        if (const std::string missing = findColumns(); !missing.empty())
            return fail("the header has no column " + missing + "; expected anchor,x_m,y_m,z_m");
        while (m_csv.next())
            if (const std::string reason = readRow(); !reason.empty())
                return fail(reason);
        if (m_anchors.empty())
            return fail("has no anchor below the header");
        return m_anchors;
    }

private:
    static constexpr std::array<std::string_view, 3> coordinateNames{"x_m", "y_m", "z_m"};

    std::unexpected<Error> fail(const std::string& reason) const
    {
        return failure(ErrorCode::BadInput, std::to_string(m_csv.line()) + ": " + reason);
    }

    /// The name of a column that is missing; empty when all are there.
    std::string findColumns()
    {
        const auto id = m_csv.column("anchor");
        if (!id)
            return "anchor";
        m_id = *id;
        for (std::size_t i = 0; i < coordinateNames.size(); ++i) {
            const auto place = m_csv.column(coordinateNames[i]);
            if (!place)
                return std::string(coordinateNames[i]);
            m_coordinates[i] = *place;
        }
        m_label = m_csv.column("label");
        m_shown = m_csv.column("shown");
        return {};
    }

    /// What is wrong with the row; empty when it became an anchor.
    std::string readRow()
    {
        const auto id = m_csv.integer(m_id);
        if (!id || *id < 0 || *id > mostId)
            return "anchor: must be a whole number from 0 to 255 (is " + inQuotes(m_csv.field(m_id)) + ")";
        const auto [first, isNew] = m_lineOf.emplace(*id, m_csv.line());
        if (!isNew)
            return "anchor: " + std::to_string(*id) + " is already in line " + std::to_string(first->second) +
                   "; every anchor has its own id";
        std::array<double, 3> place{};
        for (std::size_t i = 0; i < place.size(); ++i) {
            const auto value = m_csv.number(m_coordinates[i]);
            if (!value || std::abs(*value) > mostCoordinate_m)
                return std::string(coordinateNames[i]) + ": must be a number from -1000 to 1000 (is " +
                       inQuotes(m_csv.field(m_coordinates[i])) + ")";
            place[i] = *value;
        }
        UwbAnchor anchor{*id, "A" + std::to_string(*id), place[0], place[1], place[2], true};
        if (m_label && !m_csv.field(*m_label).empty())
            anchor.label = m_csv.field(*m_label);
        if (m_shown && !m_csv.field(*m_shown).empty()) {
            const auto shown = m_csv.integer(*m_shown);
            if (!shown || *shown < 0 || *shown > 1)
                return "shown: must be 1 or 0 (is " + inQuotes(m_csv.field(*m_shown)) + ")";
            anchor.shown = *shown == 1;
        }
        m_anchors.push_back(std::move(anchor));
        return {};
    }

    CsvTable m_csv;
    std::size_t m_id = 0;
    std::array<std::size_t, 3> m_coordinates{};
    std::optional<std::size_t> m_label;
    std::optional<std::size_t> m_shown;
    std::map<int, int> m_lineOf;
    std::vector<UwbAnchor> m_anchors;
};

} // namespace

Result<std::vector<UwbAnchor>> readAnchorCsv(std::string_view text)
{
    auto csv = CsvTable::open(text);
    if (!csv)
        return std::unexpected(csv.error());
    return AnchorTable(std::move(*csv)).read();
}

std::string writeAnchorCsv(const std::vector<UwbAnchor>& anchors)
{
    std::string text = "anchor,x_m,y_m,z_m,label,shown\n";
    for (const UwbAnchor& anchor : anchors)
        text += std::to_string(anchor.id) + "," + exactNumberText(anchor.x) + "," +
                exactNumberText(anchor.y) + "," + exactNumberText(anchor.z) + "," + csvField(anchor.label) +
                "," + (anchor.shown ? "1" : "0") + "\n";
    return text;
}

} // namespace agv::recording
