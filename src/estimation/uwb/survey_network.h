// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/anchor_survey.h"

#include <cstdint>
#include <Eigen/Core>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace agv::estimation {

/// A range between two anchors of known heights.
struct NetworkRange {
    int first = 0, second = 0;
    double rise_m = 0.0;  ///< difference of the heights
    double range_m = 0.0; ///< along the slope
    double sd_m = 0.0;    ///< > 0

    /// On the floor; 0 when the range is shorter than the rise.
    double floorDistance_m() const;
    int otherThan(int id) const { return first == id ? second : first; }
};

enum class TriangleStart : std::uint8_t {
    Placed,
    None, ///< no three anchors range with each other
    Flat  ///< some do, but all of them stand nearly on a line
};

/// Ranges between anchors, and one arrangement of these anchors on the floor, in a frame of no meaning.
class SurveyNetwork {
public:
    /// Each pair once; of a second one the later counts.
    void add(const NetworkRange& range);

    /// Places the three anchors whose triangle is the largest. `flattest`: least height of the triangle over
    /// its longest side; triangles that could be flat within the errors of their ranges do not count either.
    TriangleStart placeTriangle(double flattest);
    /// This arrangement with one anchor more, the one that ranges with most of the placed ones, at its likely
    /// places: two, when they lie apart. Empty when no anchor ranges with two placed ones.
    std::vector<SurveyNetwork> withNext() const;
    /// Towards the maximum likelihood of all placed anchors together; never fits worse than before.
    void adjust();

    const std::map<int, Eigen::Vector2d>& places() const { return m_places; } ///< by id
    std::set<int> unplaced() const;
    /// Of the ranges between placed anchors, over their variances.
    double chiSquared() const { return chiSquared(m_places); }
    int redundancy() const;    ///< ranges between placed anchors more than it takes to place them
    double residual_m() const; ///< root mean square over the ranges between placed anchors
    std::vector<NetworkRange> placedRanges() const;
    double residualOf(const NetworkRange& range) const; ///< range minus distance, m
    /// The placed anchors by id: the first is the origin, the second lies on +x, the third towards +y.
    /// @pre three are placed
    std::vector<SurveyedAnchor> inOwnFrame() const;

private:
    const NetworkRange* between(int a, int b) const;
    std::vector<NetworkRange> rangesToPlaced(int id) const;
    std::vector<Eigen::Vector2d> likelyPlaces(const std::vector<NetworkRange>& ranges, int id) const;
    /// The two places at the right distances from two placed anchors.
    std::pair<Eigen::Vector2d, Eigen::Vector2d> placesFrom(const NetworkRange& one, const NetworkRange& other,
                                                           int id) const;
    Eigen::Vector2d fitted(const std::vector<NetworkRange>& ranges, int id, Eigen::Vector2d place) const;
    double misfit(const std::vector<NetworkRange>& ranges, int id, const Eigen::Vector2d& place) const;
    double chiSquared(const std::map<int, Eigen::Vector2d>& places) const;
    /// Normal equations of all ranges: information matrix and gradient, two rows per placed anchor by id.
    void normalEquations(Eigen::MatrixXd& information, Eigen::VectorXd& gradient) const;
    Eigen::MatrixXd covariance() const;

    std::map<std::pair<int, int>, NetworkRange> m_ranges; ///< by rising ids
    std::map<int, Eigen::Vector2d> m_places;
};

/// All that the ranges allow from a network whose triangle is placed, adjusted and the most likely first; one
/// at least. An anchor that ranges with two others only, or with some on one line, has two
/// places, and which one is right may show only at an anchor that is placed later: so both are followed.
std::vector<SurveyNetwork> arrangements(const SurveyNetwork& triangle);

/// Two anchors, and how differently far apart two arrangements place them.
struct ArrangementDifference {
    int first = 0, second = 0;
    double metres = 0.0;
};

/// Where two arrangements of the same anchors differ most.
ArrangementDifference largestDifference(const SurveyNetwork& one, const SurveyNetwork& other);

} // namespace agv::estimation
