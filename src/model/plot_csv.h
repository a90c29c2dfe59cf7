// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/plot_feed.h"

#include <string>
#include <vector>

namespace agv::model {

/// The curves `keys` in [from, to] as CSV (UTF-8, comma, point, CRLF as in RFC 4180): `t_s` since the first
/// snapshot, `t_utc` (ISO 8601, ms, Z), a column for each curve with its unit in the name. A curve without a
/// value at a time leaves its field empty.
std::string plotCsv(const PlotFeed& feed, const std::vector<SeriesKey>& keys, double from, double to);

} // namespace agv::model
