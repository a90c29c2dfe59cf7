// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/fusion/position_fusion.h"
#include "estimation/uwb/linear_toa.h"
#include "estimation/uwb/locator_parts.h"
#include "estimation/uwb/robust_fix.h"
#include "estimation/uwb/switching_rule.h"

namespace agv::estimation {

namespace {

/// A floor tag fix is given with a report when it is not older.
constexpr double kFloorTagAge_s = 0.5;

UwbFix firstFix(AnchorRanges ranges, double height_m)
{
    return robustFix(ranges, {.height = TagHeight{height_m, 0.0}, .obstruction = {}}).fix;
}

class PositionLocator final : public Locator {
public:
    explicit PositionLocator(const LocatorSettings& settings)
        : m_height_m(settings.height_m),
          m_filter(of(settings))
    {}
    Located locate(double time_s, AnchorRanges ranges) override
    {
        advance(time_s);
        if (!m_filter.started()) {
            const UwbFix fix = firstFix(ranges, m_height_m);
            if (!fix.ok())
                return locatedFrom(fix);
            m_filter.start(fix.position.head<2>());
        }
        const MeasurementRecords& records = m_filter.update(ranges);
        Located result = locatedAt(m_filter.position(), m_filter.covariance(), m_height_m);
        result.records = records;
        return result;
    }
    void floorTag(double time_s, Point2 position) override
    {
        advance(time_s);
        if (m_filter.started())
            m_filter.updateFloorTag({position.x, position.y});
        else
            m_filter.start({position.x, position.y});
    }

private:
    static PositionFusionSettings of(const LocatorSettings& settings)
    {
        PositionFusionSettings result;
        result.model.height_m = settings.height_m;
        result.anchors = static_cast<int>(settings.anchors.size());
        result.acceleration = settings.acceleration;
        return result;
    }
    void advance(double time_s) { m_filter.predict(m_clock.since(time_s)); }

    double m_height_m;
    PositionFusion m_filter;
    Stopwatch m_clock;
};

/// Until every anchor was heard once the vehicle is taken to stand still; then the filter starts.
class VehicleLocator final : public Locator {
public:
    explicit VehicleLocator(const LocatorSettings& settings)
        : m_settings(settings),
          m_filter(of(settings)),
          m_first(settings.anchors.size())
    {
        if (settings.startPose)
            m_filter.start(*settings.startPose);
    }
    Located locate(double, AnchorRanges ranges) override
    {
        if (!m_filter.started()) {
            start(ranges);
            if (!m_filter.started())
                return {};
            return answer();
        }
        const MeasurementRecords& records = m_filter.update(ranges, m_settings.mount);
        Located result = answer();
        result.records = records;
        return result;
    }
    void odometry(double, const OdometryStep& step, double dt_s) override { m_filter.predict(step, dt_s); }
    void floorTag(double, Point2 position) override { m_filter.updateFloorTag({position.x, position.y}); }

private:
    static VehicleFusionSettings of(const LocatorSettings& settings)
    {
        VehicleFusionSettings result;
        result.model.height_m = settings.height_m;
        result.anchors = static_cast<int>(settings.anchors.size());
        return result;
    }
    void start(AnchorRanges ranges)
    {
        for (const AnchorRange& range : ranges)
            if (range.index >= 0 && static_cast<std::size_t>(range.index) < m_first.size())
                m_first[static_cast<std::size_t>(range.index)] = range;
        AnchorRangeList heard;
        for (const auto& range : m_first)
            if (range)
                heard.add(*range);
        if (heard.size() < m_first.size())
            return;
        const UwbFix fix = firstFix({heard.data(), heard.size()}, m_settings.height_m);
        if (!fix.ok())
            return;
        const double heading = m_settings.startHeading.value_or(0.0);
        const Point2 centre =
            fromVehicleFrame({{fix.position.x(), fix.position.y()}, heading}, -1.0 * m_settings.mount);
        m_filter.start(Pose2{centre, heading});
    }
    Located answer() const
    {
        const Pose2 pose = m_filter.pose();
        const PoseCovariance c = m_filter.covariance();
        Eigen::Matrix2d covariance;
        covariance << c[0], c[1], c[3], c[4];
        Located result = locatedAt({pose.position.x, pose.position.y}, covariance, m_settings.height_m);
        result.heading = pose.heading;
        return result;
    }

    LocatorSettings m_settings;
    VehicleFusion m_filter;
    std::vector<std::optional<AnchorRange>> m_first;
};

/// Positions of two systems and a rule: thesis methods that see no single range.
class FixRule final : public Locator {
public:
    FixRule(const LocatorSettings& settings, bool useUwb)
        : m_height_m(settings.height_m),
          m_useUwb(useUwb),
          m_rule(settings.anchors)
    {}
    Located locate(double time_s, AnchorRanges ranges) override
    {
        const bool fresh = m_tag && time_s - m_tagTime_s <= kFloorTagAge_s;
        const std::optional<Point2> tag = fresh ? m_tag : std::nullopt;
        m_tag.reset();
        std::optional<Point2> uwb;
        const UwbFix fix = linearToa2d(ranges, TagHeight{m_height_m, 0.0});
        if (m_useUwb && fix.ok())
            uwb = Point2{fix.position.x(), fix.position.y()};
        const auto position = m_useUwb ? m_rule.choose(uwb, tag).position : tag;
        if (!position)
            return {};
        return locatedAt({position->x, position->y}, Eigen::Matrix2d::Zero(), m_height_m);
    }
    void floorTag(double time_s, Point2 position) override
    {
        m_tag = position;
        m_tagTime_s = time_s;
    }

private:
    double m_height_m;
    bool m_useUwb;
    SwitchingRule m_rule;
    std::optional<Point2> m_tag;
    double m_tagTime_s = 0.0;
};

} // namespace

std::unique_ptr<Locator> makeFusionLocator(std::string_view name, const LocatorSettings& settings)
{
    if (name == "fusion")
        return std::make_unique<VehicleLocator>(settings);
    if (name == "fusion-position")
        return std::make_unique<PositionLocator>(settings);
    if (name == "switching" || name == "rfid-average")
        return std::make_unique<FixRule>(settings, name == "switching");
    return nullptr;
}

} // namespace agv::estimation
