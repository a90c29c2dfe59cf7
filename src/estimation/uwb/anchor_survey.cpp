// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/anchor_survey.h"

#include "estimation/uwb/survey_network.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <string>
#include <utility>

namespace agv::estimation {
namespace {

constexpr double surelySds = 3.0;
constexpr double unlike_m = 0.1; ///< less is the same arrangement
/// Sd of a median of normal values over the one of their mean, sqrt(pi / 2).
constexpr double medianOverMean = 1.2533;

std::string number(int value) { return std::to_string(value); }

std::string mm(double metres) { return std::to_string(std::lround(mmFromMetres(metres))) + " mm"; }

std::string between(int first, int second) { return "anchors " + number(first) + " and " + number(second); }

/// "2" or "1, 2"
std::string joined(const std::set<int>& ids)
{
    std::string text;
    for (const int id : ids)
        text += (text.empty() ? "" : ", ") + number(id);
    return text;
}

class Surveyor {
public:
    Surveyor(const std::vector<UwbAnchor>& anchors, const AnchorSurveySettings& settings)
        : m_listed(anchors),
          m_settings(settings)
    {}

    AnchorSurvey survey(const std::vector<AnchorPairSnapshot>& pairs)
    {
        m_result.trouble = takePairs(pairs);
        if (m_result.trouble.empty())
            m_result.trouble = place();
        return std::move(m_result);
    }

private:
    const UwbAnchor* find(int id) const
    {
        const auto found = std::ranges::find(m_listed, id, &UwbAnchor::id);
        return found == m_listed.end() ? nullptr : &*found;
    }

    std::string takePairs(const std::vector<AnchorPairSnapshot>& pairs)
    {
        if (m_listed.empty())
            return "There is no anchor in the list: enter the anchors with their heights first";
        std::set<int> unlisted;
        std::set<int> ranging;
        for (const AnchorPairSnapshot& pair : pairs) {
            for (const int id : {pair.first, pair.second})
                if (!find(id))
                    unlisted.insert(id);
            const UwbAnchor* const first = find(pair.first);
            const UwbAnchor* const second = find(pair.second);
            if (!first || !second || first == second || pair.count < m_settings.rangesNeeded)
                continue;
            const double rise = first->z - second->z;
            const double medianSd = medianOverMean * pair.sd_m / std::sqrt(pair.count);
            const double sd = std::hypot(medianSd, m_settings.pairSd_m);
            if (!(pair.range_m > std::abs(rise) - surelySds * sd))
                return "The range between " + between(pair.first, pair.second) + " (" + mm(pair.range_m) +
                       ") is shorter than the difference of their heights (" + mm(std::abs(rise)) +
                       "): correct the heights in the list";
            ranging.insert({pair.first, pair.second});
            m_network.add({.first = pair.first,
                           .second = pair.second,
                           .rise_m = rise,
                           .range_m = pair.range_m,
                           .sd_m = sd});
        }
        if (ranging.empty())
            return "No ranges between the anchors were heard: switch the anchors on and connect the unit "
                   "that is anchor 0";
        noteSilent(unlisted, ranging);
        return {};
    }

    void noteSilent(const std::set<int>& unlisted, const std::set<int>& ranging)
    {
        if (!unlisted.empty())
            note("Anchor " + joined(unlisted) + " is not in the list: enter its height to have it placed");
        std::set<int> silent;
        for (const UwbAnchor& anchor : m_listed)
            if (!ranging.contains(anchor.id))
                silent.insert(anchor.id);
        if (!silent.empty())
            note("Anchor " + joined(silent) + " has no ranges to the others and stays where it is");
    }

    std::string place()
    {
        switch (m_network.placeTriangle(m_settings.flattest)) {
        case TriangleStart::Placed:
            break;
        case TriangleStart::None:
            return "Too few pairs of anchors range with each other: three anchors that all see each other "
                   "are needed";
        case TriangleStart::Flat:
            return "The anchors stand nearly on one line: their ranges do not tell how far beside it; move "
                   "one of them aside";
        }
        const std::vector<SurveyNetwork> likely = arrangements(m_network);
        if (likely.front().residual_m() > m_settings.hopelessBeyond_m)
            return "The ranges between the anchors fit no arrangement: look for what hides the anchors from "
                   "each other";
        m_network = nearestToList(likely);
        m_result.anchors = m_network.inOwnFrame();
        m_result.residual_m = m_network.residual_m();
        if (const std::set<int> left = m_network.unplaced(); !left.empty())
            note("Anchor " + joined(left) +
                 " has too few ranges to the others to be placed and stays where it is");
        for (const NetworkRange& range : m_network.placedRanges())
            if (const double off = m_network.residualOf(range); std::abs(off) > m_settings.noteBeyond_m)
                note("The range between " + between(range.first, range.second) + " is " + mm(std::abs(off)) +
                     (off > 0.0 ? " too long" : " too short") + ": look for what stands between them");
        return {};
    }

    /// Of the arrangements that fit nearly as well as the first. @pre `likely` is not empty
    const SurveyNetwork& nearestToList(const std::vector<SurveyNetwork>& likely)
    {
        const SurveyNetwork& best = likely.front();
        const double scale = std::max(1.0, best.chiSquared() / std::max(1, best.redundancy()));
        const double most = best.chiSquared() + surelySds * surelySds * scale;
        const auto end = std::ranges::find_if(
            likely, [=](const SurveyNetwork& network) { return network.chiSquared() > most; });
        const std::span fitting(likely.begin(), end);
        const SurveyNetwork& nearest = *std::ranges::min_element(
            fitting, {}, [this](const SurveyNetwork& network) { return distanceFromList(network); });
        ArrangementDifference largest;
        for (const SurveyNetwork& other : fitting)
            if (const auto difference = largestDifference(nearest, other); difference.metres > largest.metres)
                largest = difference;
        if (largest.metres > unlike_m)
            note("More than one arrangement fits the ranges and the one nearest to the list was taken: look "
                 "whether it is right, the range between " +
                 between(largest.first, largest.second) + " would tell");
        return nearest;
    }

    /// Sum of squares, m^2, in the closest frame.
    double distanceFromList(const SurveyNetwork& network) const
    {
        AnchorSurvey survey;
        for (const auto& [id, place] : network.places())
            survey.anchors.push_back({.id = id, .position = {place.x(), place.y()}});
        const std::vector<UwbAnchor> moved = placed(survey, closestFrame(survey, m_listed), m_listed);
        double sum = 0.0;
        for (std::size_t i = 0; i < moved.size(); ++i)
            sum += std::pow(moved[i].x - m_listed[i].x, 2) + std::pow(moved[i].y - m_listed[i].y, 2);
        return sum;
    }

    void note(std::string text) { m_result.notes.push_back(std::move(text)); }

    const std::vector<UwbAnchor>& m_listed;
    const AnchorSurveySettings& m_settings;
    SurveyNetwork m_network;
    AnchorSurvey m_result;
};

} // namespace

AnchorSurvey surveyAnchors(const std::vector<AnchorPairSnapshot>& pairs, const std::vector<UwbAnchor>& listed,
                           const AnchorSurveySettings& settings)
{
    return Surveyor(listed, settings).survey(pairs);
}

} // namespace agv::estimation
