// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/run_tables.h"

#include <cmath>
#include <limits>
#include <optional>

namespace agv::recording {
namespace {

constexpr double perUnit = 1e6; ///< micrometres a metre, millionths

constexpr const char* rangeKinds[] = {"tag", "anchor"};
constexpr const char* noYes[] = {"no", "yes"};
constexpr const char* healths[] = {"none", "tracked", "predicted", "doubted"};
constexpr const char* phases[] = {"idle",    "settling", "reading", "turning",
                                  "solving", "finished", "aborted", "failed"};
constexpr const char* levels[] = {"detail", "info", "warning", "error"};
constexpr const char* robotStates[] = {
    "idle",           "segment_driving",   "segment_waiting", "direct_driving", "station_docking",
    "station_docked", "station_undocking", "demo_docking",    "error"};
constexpr const char* chargingStates[] = {"not_charging", "reconditioning", "full_charging",
                                          "trickle",      "waiting",        "fault"};
static_assert(std::size(healths) == static_cast<std::size_t>(PoseHealth::Doubted) + 1);
static_assert(std::size(phases) == static_cast<std::size_t>(TurnPhase::Failed) + 1);
static_assert(std::size(levels) == static_cast<std::size_t>(EventLevel::Error) + 1);
static_assert(std::size(robotStates) == static_cast<std::size_t>(RobotState::Error) + 1);
static_assert(std::size(chargingStates) == static_cast<std::size_t>(ChargingState::Fault) + 1);

using enum ColumnKind;

constexpr RunColumn floorReadColumns[] = {{"agv", "agv"}, {"uid", "uid", TagNumber}, {"rssi", "rssi"}};
constexpr RunColumn rangeColumns[] = {{"age_us", "age_ms", Decimal, 3},
                                      {"kind", "kind", Word, 0, rangeKinds},
                                      {"tag", "tag"},
                                      {"anchor", "anchor"},
                                      {"sequence", "sequence"},
                                      {"range_um", "range_mm", Decimal, 3},
                                      {"residual_um", "residual_mm", Decimal, 3},
                                      {"rejected", "rejected", Word, 0, noYes}};
constexpr RunColumn tagPositionColumns[] = {
    {"age_us", "age_ms", Decimal, 3},
    {"tag", "tag"},
    {"x_um", "x_mm", Decimal, 3},
    {"y_um", "y_mm", Decimal, 3},
    {"sd_x_um", "sd_x_mm", Decimal, 3},
    {"sd_y_um", "sd_y_mm", Decimal, 3},
    {"correlation_ppm", "correlation", Decimal, 6},
};
constexpr RunColumn poseColumns[] = {
    {"agv", "agv"},
    {"x_um", "x_mm", Decimal, 3},
    {"y_um", "y_mm", Decimal, 3},
    {"heading_udeg", "heading_deg", Decimal, 6},
    {"sd_x_um", "sd_x_mm", Decimal, 3},
    {"sd_y_um", "sd_y_mm", Decimal, 3},
    {"sd_heading_udeg", "sd_heading_deg", Decimal, 6},
    {"correlation_xy_ppm", "correlation_xy", Decimal, 6},
    {"correlation_xh_ppm", "correlation_x_heading", Decimal, 6},
    {"correlation_yh_ppm", "correlation_y_heading", Decimal, 6},
    {"health", "health", Word, 0, healths},
};
constexpr RunColumn wheelCommandColumns[] = {
    {"agv", "agv"},
    {"left_um_s", "left_mm_s", Decimal, 3},
    {"right_um_s", "right_mm_s", Decimal, 3},
};
constexpr RunColumn robotStateColumns[] = {{"agv", "agv"}, {"state", "state", Word, 0, robotStates}};
constexpr RunColumn batteryColumns[] = {{"agv", "agv"},
                                        {"charging", "charging", Word, 0, chargingStates},
                                        {"voltage_mV", "voltage_V", Decimal, 3},
                                        {"current_mA", "current_A", Decimal, 3},
                                        {"temperature_degC", "temperature_degC"},
                                        {"charge_mAh", "charge_Ah", Decimal, 3},
                                        {"capacity_mAh", "capacity_Ah", Decimal, 3}};
constexpr RunColumn turnStepColumns[] = {
    {"agv", "agv"}, {"phase", "phase", Word, 0, phases}, {"stop", "stop"}};
constexpr RunColumn turnResultColumns[] = {
    {"agv", "agv"},
    {"phase", "phase", Word, 0, phases},
    {"x_um", "x_mm", Decimal, 3},
    {"y_um", "y_mm", Decimal, 3},
    {"heading_udeg", "heading_deg", Decimal, 6},
    {"sd_x_um", "sd_x_mm", Decimal, 3},
    {"sd_y_um", "sd_y_mm", Decimal, 3},
    {"sd_heading_udeg", "sd_heading_deg", Decimal, 6},
    {"note", "note", Text},
};
constexpr RunColumn eventColumns[] = {
    {"level", "level", Word, 0, levels}, {"source", "source", Text}, {"text", "text", Text}};
constexpr RunColumn operatorActionColumns[] = {
    {"action", "action", Text}, {"agv", "agv"}, {"detail", "detail", Text}};

constexpr std::array<RunTable, runTableCount> tables{{{"floor_reads", floorReadColumns},
                                                      {"ranges", rangeColumns},
                                                      {"tag_positions", tagPositionColumns},
                                                      {"poses", poseColumns},
                                                      {"wheel_commands", wheelCommandColumns},
                                                      {"robot_states", robotStateColumns},
                                                      {"battery", batteryColumns},
                                                      {"turn_steps", turnStepColumns},
                                                      {"turn_results", turnResultColumns},
                                                      {"events", eventColumns},
                                                      {"operator_actions", operatorActionColumns}}};

/// Nothing for what no integer can hold.
RunCell wholeNumber(double value)
{
    constexpr double largest = 9e15; // every integer below is a double, too
    if (!(std::abs(value) <= largest))
        return {};
    return static_cast<std::int64_t>(std::llround(value));
}

RunCell micro(double value) { return wholeNumber(value * perUnit); }
RunCell milli(double value) { return wholeNumber(value * 1e3); }
RunCell microDegrees(double rad) { return micro(degFromRad(rad)); }
RunCell integer(std::int64_t value) { return value; }
RunCell agvCell(RobotId agv) { return integer(agv.number); }
template<typename Enum>
RunCell word(Enum value)
{
    return integer(static_cast<std::int64_t>(value));
}

RunCell correlation(double covariance, double varianceA, double varianceB)
{
    return micro(covariance / std::sqrt(varianceA * varianceB));
}

RunCell age(Time arrival, double measured_s)
{
    return micro(secondsFrom(arrival.time_since_epoch()) - measured_s);
}

/// Fills the cells from left to right.
class CellFiller {
public:
    explicit CellFiller(RunCells& cells) : m_cells(cells) {}
    CellFiller& operator<<(const RunCell& cell)
    {
        m_cells.cells.at(m_cells.count++) = cell;
        return *this;
    }
    CellFiller& sds(const PoseCovariance& p)
    {
        return *this << micro(std::sqrt(p[0])) << micro(std::sqrt(p[4])) << microDegrees(std::sqrt(p[8]));
    }

private:
    RunCells& m_cells;
};

Time fill(CellFiller& to, const TagReadRow& row)
{
    to << agvCell(row.agv) << integer(static_cast<std::int64_t>(row.read.uid.value))
       << integer(row.read.rssi);
    return row.read.time;
}

Time fill(CellFiller& to, const RangeRow& row)
{
    const RangeMeasurement& range = row.range;
    to << age(row.arrival, range.time_s) << word(range.kind) << integer(range.tag) << integer(range.anchor)
       << (range.sequence >= 0 ? integer(range.sequence) : RunCell()) << micro(range.range_m)
       << (row.residual_m ? micro(*row.residual_m) : RunCell()) << integer(row.rejected ? 1 : 0);
    return row.arrival;
}

Time fill(CellFiller& to, const TagPositionRow& row)
{
    const PositionCovariance& p = row.covariance;
    to << age(row.arrival, row.measured_s) << integer(row.tag) << micro(row.position.x)
       << micro(row.position.y) << micro(std::sqrt(p.xx)) << micro(std::sqrt(p.yy))
       << correlation(p.xy, p.xx, p.yy);
    return row.arrival;
}

Time fill(CellFiller& to, const PoseRow& row)
{
    const PoseCovariance& p = row.covariance;
    to << agvCell(row.agv) << micro(row.pose.position.x) << micro(row.pose.position.y)
       << microDegrees(row.pose.heading);
    to.sds(p) << correlation(p[1], p[0], p[4]) << correlation(p[2], p[0], p[8])
              << correlation(p[5], p[4], p[8]) << word(row.health);
    return row.time;
}

Time fill(CellFiller& to, const WheelCommandRow& row)
{
    to << agvCell(row.agv) << micro(row.speeds.left) << micro(row.speeds.right);
    return row.time;
}

Time fill(CellFiller& to, const RobotStateRow& row)
{
    to << agvCell(row.agv) << word(row.state);
    return row.time;
}

Time fill(CellFiller& to, const BatteryRow& row)
{
    const BatteryStatus& battery = row.battery;
    to << agvCell(row.agv) << word(battery.charging) << milli(battery.voltage_V) << milli(battery.current_A)
       << integer(battery.temperature_degC) << milli(battery.charge_Ah) << milli(battery.capacity_Ah);
    return row.time;
}

Time fill(CellFiller& to, const TurnStepRow& row)
{
    to << agvCell(row.agv) << word(row.phase) << integer(row.stop);
    return row.time;
}

Time fill(CellFiller& to, const TurnResultRow& row)
{
    to << agvCell(row.agv) << word(row.phase);
    if (row.pose) {
        to << micro(row.pose->position.x) << micro(row.pose->position.y) << microDegrees(row.pose->heading);
        to.sds(row.covariance);
    } else {
        to << RunCell() << RunCell() << RunCell() << RunCell() << RunCell() << RunCell();
    }
    to << std::string_view(row.note);
    return row.time;
}

Time fill(CellFiller& to, const EventRow& row)
{
    to << word(row.event.level) << std::string_view(row.event.source) << std::string_view(row.event.text);
    return row.time;
}

Time fill(CellFiller& to, const OperatorActionRow& row)
{
    to << std::string_view(row.action) << (row.agv ? agvCell(*row.agv) : RunCell())
       << std::string_view(row.detail);
    return row.time;
}

} // namespace

std::span<const RunTable, runTableCount> runTables() { return tables; }

RunCells cellsOf(const RunRow& row)
{
    RunCells cells;
    cells.table = row.index();
    CellFiller filler(cells);
    cells.time = std::visit([&filler](const auto& one) { return fill(filler, one); }, row);
    return cells;
}

std::string runSchema()
{
    std::string sql = "CREATE TABLE clocks (t_ns INTEGER NOT NULL, utc_us INTEGER NOT NULL);"
                      "CREATE TABLE links (id INTEGER PRIMARY KEY, name TEXT NOT NULL);"
                      "CREATE TABLE raw (t_ns INTEGER NOT NULL, utc_us INTEGER NOT NULL,"
                      " link INTEGER NOT NULL, packed BLOB NOT NULL);";
    for (const RunTable& table : tables) {
        sql += std::string("CREATE TABLE ") + table.name + " (t_ns INTEGER NOT NULL";
        for (const RunColumn& column : table.columns)
            sql += std::string(", ") + column.name + (column.kind == Text ? " TEXT" : " INTEGER");
        sql += ");";
    }
    return sql;
}

std::string insertStatement(const RunTable& table)
{
    std::string sql = std::string("INSERT INTO ") + table.name + " VALUES (?";
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        sql += ", ?";
    return sql + ")";
}

} // namespace agv::recording
