// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/rssi_likelihood.h"
#include "estimation/turn_solver.h"

#include <string>
#include <variant>
#include <vector>

namespace agv::estimation {

/// One factor of a stop's likelihood: weight * log P(outcome | distance to the tag).
struct TagTerm {
    float x = 0.0F; ///< m, relative to TurnEvidence::origin
    float y = 0.0F;
    TagOutcome outcome = kNotRead;
    float weight = 1.0F;
};

/// What one stop says, cleaned.
struct StopEvidence {
    std::vector<TagTerm> terms; ///< tags read, then tags in reach that were not read
    std::size_t readTerms = 0;  ///< the first terms are of tags that were read
    int tagsRead = 0;           ///< different tags, known and near
    int reads = 0;              ///< all of their reads
    Point2 meanOfRead;          ///< relative to the origin; only with tagsRead > 0
    std::vector<TagUid> unknown;
    std::vector<TagUid> misplaced;
};

/// A tag that may be read during the turn.
struct NearTag {
    TagUid uid;
    Point2 position; ///< relative to the origin, m
};

/// The record reduced to what a solver needs, in a local frame.
struct TurnEvidence {
    Point2 origin; ///< plant frame, m: middle of the tags read; the centre is within `searchHalf_m` of it
    std::vector<StopEvidence> stops;
    std::vector<NearTag> nearTags;
    double nominalStep = 0.0;    ///< rad, > 0
    double radius_m = 0.0;       ///< antenna to centre, > 0
    double antennaBearing = 0.0; ///< of the antenna in the vehicle frame: heading = bearing - this
    double searchHalf_m = 0.0;   ///< half width of the box the centre is searched in
    int tagsRead = 0;            ///< sum over the stops
    double missed = 0.0;         ///< rough share of the tags in reach that were not read, 0..1
    int stopsWithReads = 0;
};

/// Reads of one tag at one stop come through the same antenna position and the same metal nearby, so their
/// errors are correlated; n of them count as n / (1 + (n - 1) rho) independent ones, at most 1 / rho.
constexpr double kReadCorrelation = 0.5;
/// Log odds of the commanded direction of the turn, 95 : 5; before any read.
constexpr double kRotationPriorLogOdds = 3.0;

/// Cleans a record. Reads with an RSSI outside 0..7 are ignored, tags without a place in the map are
/// reported, tags read far from all others are set aside as misplaced. A stop without reads still speaks:
/// the tags near it were not read. Returns the reason when there is nothing to solve: "no_reads",
/// "no_step", "antenna_at_centre", "rssi_table_...".
std::variant<TurnEvidence, std::string> prepareEvidence(const TurnRecord& record, const TurnContext& context);

} // namespace agv::estimation
