// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/locator.h"

#include "estimation/uwb/locator_parts.h"

#include "estimation/uwb/biased_kalman.h"
#include "estimation/uwb/linear_toa.h"
#include "estimation/uwb/planar_ekf.h"
#include "estimation/uwb/range_ekf.h"
#include "estimation/uwb/range_fix.h"
#include "estimation/uwb/range_particle_filter.h"
#include "estimation/uwb/robust_fix.h"
#include "estimation/uwb/static_position.h"
#include "estimation/uwb/tdoa.h"
#include "estimation/uwb/two_step_toa.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string>

namespace agv::estimation {

namespace {

/// Mean error the biased filter is told: a fifth of the ranges hidden, 0.35 m each.
constexpr double kMeanBias_m = 0.07;

/// A method that knows nothing but the report.
class SingleReport final : public Locator {
public:
    using Solve = std::function<Located(AnchorRanges)>;
    explicit SingleReport(Solve solve) : m_solve(std::move(solve)) {}
    Located locate(double, AnchorRanges ranges) override { return m_solve(ranges); }

private:
    Solve m_solve;
};

/// After a longer silence a tracker starts anew: an acceleration of 0.15 m/s^2 may have moved the tag by
/// metres, too far for the linearised update.
constexpr double kLongestSilence_s = 10.0;

/// Filters with start(ranges), predict(dt), update(ranges).
template<typename Filter, typename Answer>
class Tracker final : public Locator {
public:
    Tracker(Filter filter, Answer answer) : m_filter(std::move(filter)), m_answer(answer) {}

    Located locate(double time_s, AnchorRanges ranges) override
    {
        const double dt = m_clock.since(time_s);
        m_isLost = m_isLost || dt > kLongestSilence_s;
        if (m_filter.started() && !m_isLost)
            m_filter.predict(dt);
        else if (!m_filter.start(ranges))
            return {};
        m_isLost = false;
        const MeasurementRecords& records = m_filter.update(ranges);
        Located result = m_answer(m_filter);
        result.records = records;
        return result;
    }
    void floorTag(double, Point2 position) override
    {
        if constexpr (requires { m_filter.updateFloorTag(Eigen::Vector2d()); })
            m_filter.updateFloorTag({position.x, position.y});
    }

private:
    Filter m_filter;
    Answer m_answer;
    Stopwatch m_clock;
    bool m_isLost = false; ///< nothing was heard for too long
};

template<typename Filter, typename Answer>
std::unique_ptr<Locator> track(Filter filter, Answer answer)
{
    return std::make_unique<Tracker<Filter, Answer>>(std::move(filter), answer);
}

class StaticTag final : public Locator {
public:
    explicit StaticTag(double height_m) : m_position({.height_m = height_m, .obstruction = {}}) {}
    Located locate(double, AnchorRanges ranges) override
    {
        m_position.add(ranges);
        Located result = locatedFrom(m_position.fix());
        if (result.ok())
            result.records = m_position.explain(ranges, result.position.head<2>());
        return result;
    }

private:
    StaticPosition m_position;
};

class BiasedRanges final : public Locator {
public:
    explicit BiasedRanges(const LocatorSettings& settings) : m_height_m(settings.height_m)
    {
        m_filters.fill(BiasedKalman({.meanBias_m = kMeanBias_m, .acceleration = settings.acceleration}));
    }
    Located locate(double time_s, AnchorRanges ranges) override
    {
        const double dt = m_clock.since(time_s);
        for (BiasedKalman& filter : m_filters)
            filter.predict(dt);
        AnchorRangeList filtered;
        MeasurementRecords records;
        for (AnchorRange range : ranges) {
            if (range.index < 0 || range.index >= kMaxAnchors)
                continue;
            BiasedKalman& filter = m_filters[static_cast<std::size_t>(range.index)];
            records.add(filter.update(range.range_m));
            range.range_m = std::max(filter.range_m(), 0.0);
            filtered.add(range);
        }
        Located result = locatedFrom(
            fixFromRanges({filtered.data(), filtered.size()}, {.height = TagHeight{m_height_m, 0.0}}));
        result.records = records;
        return result;
    }

private:
    double m_height_m;
    std::array<BiasedKalman, kMaxAnchors> m_filters;
    Stopwatch m_clock;
};

std::unique_ptr<Locator> single(SingleReport::Solve solve)
{
    return std::make_unique<SingleReport>(std::move(solve));
}

Located robustAnswer(AnchorRanges ranges, double height_m)
{
    const RobustFix robust = robustFix(ranges, {.height = TagHeight{height_m, 0.0}, .obstruction = {}});
    Located result = locatedFrom(robust.fix);
    result.records = robust.records;
    return result;
}

Located tdoaAnswer(AnchorRanges ranges, double height_m)
{
    FixedList<RangeDifference, kMaxAnchors> differences;
    for (const AnchorRange& range : ranges)
        differences.add({range.anchor, range.range_m - ranges[0].range_m, range.sd_m});
    return locatedFrom(tdoaFix({differences.data(), differences.size()}, height_m));
}

std::unique_ptr<Locator> makeSingle(std::string_view name, double z)
{
    const TagHeight height{z, 0.0};
    if (name == "robust")
        return single([=](AnchorRanges r) { return robustAnswer(r, z); });
    if (name == "gauss-newton")
        return single([=](AnchorRanges r) { return locatedFrom(fixFromRanges(r, {.height = height})); });
    if (name == "gauss-newton-3d")
        return single([](AnchorRanges r) { return locatedFrom(fixFromRanges(r)); });
    if (name == "huber")
        return single(
            [=](AnchorRanges r) { return locatedFrom(fixFromRanges(r, {.height = height, .huber = 1.5})); });
    if (name == "linear-2d")
        return single([=](AnchorRanges r) { return locatedFrom(linearToa2d(r, height)); });
    if (name == "linear-3d")
        return single([](AnchorRanges r) { return locatedFrom(linearToa3d(r).fix); });
    if (name == "two-step")
        return single([](AnchorRanges r) { return locatedFrom(twoStepToa(r).fix); });
    if (name == "two-step-published")
        return single([](AnchorRanges r) { return locatedFrom(twoStepToa(r, {.originShift_m = 0.0}).fix); });
    if (name == "tdoa")
        return single([=](AnchorRanges r) { return tdoaAnswer(r, z); });
    return nullptr;
}

std::unique_ptr<Locator> makeTracker(std::string_view name, const LocatorSettings& settings)
{
    const double z = settings.height_m;
    const auto ekf = [&](RangeEkfMode mode) {
        return track(
            RangeEkf({.mode = mode, .height_m = z, .acceleration = settings.acceleration, .obstruction = {}}),
            [z](const RangeEkf& f) {
                return locatedAt(f.state().head<2>(), f.covariance().topLeftCorner<2, 2>(), z);
            });
    };
    if (name == "ekf-los")
        return ekf(RangeEkfMode::LineOfSight);
    if (name == "ekf")
        return ekf(RangeEkfMode::Plain);
    if (name == "ekf-robust")
        return ekf(RangeEkfMode::Robust);
    if (name == "ekf-manual")
        return track(PlanarEkf({.height_m = z}),
                     [z](const PlanarEkf& f) { return locatedAt(f.position(), f.covariance(), z); });
    if (name == "particle" || name == "fusion-particle")
        return track(
            RangeParticleFilter(
                {.height_m = z, .acceleration = settings.acceleration, .seed = settings.seed}),
            [z](const RangeParticleFilter& f) { return locatedAt(f.position(), f.covariance(), z); });
    if (name == "static")
        return std::make_unique<StaticTag>(z);
    if (name == "biased-kalman")
        return std::make_unique<BiasedRanges>(settings);
    return makeFusionLocator(name, settings);
}

} // namespace

void Locator::odometry(double, const OdometryStep&, double) {}
void Locator::floorTag(double, Point2) {}

Result<std::unique_ptr<Locator>> makeLocator(std::string_view name, const LocatorSettings& settings)
{
    const MethodInfo* method = findMethod(name);
    if (method == nullptr) {
        std::string names;
        for (const MethodInfo& m : allMethods())
            names += (names.empty() ? "" : ", ") + std::string(m.name);
        return failure(ErrorCode::NotFound,
                       "there is no method " + std::string(name) + "; the methods are " + names);
    }
    if (method->input == MethodInput::Special)
        return failure(ErrorCode::BadInput, "method " + std::string(name) +
                                                " does not run on ranges: " + std::string(method->title));
    if (settings.anchors.size() > kMaxAnchors)
        return failure(ErrorCode::BadInput, "there are " + std::to_string(settings.anchors.size()) +
                                                " anchors; at most " + std::to_string(kMaxAnchors) +
                                                " can be used at once");
    if (auto made = makeSingle(name, settings.height_m))
        return made;
    return makeTracker(name, settings);
}

} // namespace agv::estimation
