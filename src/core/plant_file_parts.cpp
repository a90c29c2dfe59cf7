// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plant_file_parts.h"

#include "core/file_units.h"

namespace agv {

Point2 readPoint(const Json& json, const std::string& pointer, JsonFindings& findings)
{
    if (!json.is_array() || json.size() != 2) {
        findings.errors.push_back({pointer, "must be a point [x, y] in mm (is " + describe(json) + ")"});
        return {};
    }
    const auto x = readNumber(json[0], pointer + "/0", coordinateRange, findings);
    const auto y = readNumber(json[1], pointer + "/1", coordinateRange, findings);
    return {fromThousandths(x.value_or(0)), fromThousandths(y.value_or(0))};
}

Point2 readPoint(JsonFields& fields, std::string_view key)
{
    const Json* const json = fields.find(key);
    return json == nullptr ? Point2{} : readPoint(*json, fields.pointerTo(key), fields.findings());
}

Point2 readPosition(JsonFields& fields)
{
    const double x = fields.thousandths("x_mm", coordinateRange, std::nullopt);
    return {x, fields.thousandths("y_mm", coordinateRange, std::nullopt)};
}

void PlantArea::requireInside(Point2 p, const std::string& pointer, const std::string& what,
                              JsonFindings& findings) const
{
    constexpr double rounding_m = 1e-6; // sums such as origin + 30 * pitch are not exact
    const auto within = [&](double value, double from, double length) {
        return value >= from - rounding_m && value <= from + length + rounding_m;
    };
    if (!m_known || (within(p.x, m_origin.x, m_size.x) && within(p.y, m_origin.y, m_size.y)))
        return;
    const auto mm = [](double m) { return decimalText(toThousandths(m)); };
    findings.errors.push_back({pointer, what + " at (" + mm(p.x) + ", " + mm(p.y) +
                                            ") mm is outside the plant, which reaches from (" +
                                            mm(m_origin.x) + ", " + mm(m_origin.y) + ") to (" +
                                            mm(m_origin.x + m_size.x) + ", " + mm(m_origin.y + m_size.y) +
                                            ") mm; correct it or /size"});
}

} // namespace agv
