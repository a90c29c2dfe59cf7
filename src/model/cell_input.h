// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/result.h"

#include <optional>

namespace agv::model {

/// What people type into the cells of a table, and how it is shown there. Numbers are read in the default
/// QLocale and, where that fails, as files write them (point, no groups).
class CellInput {
    Q_DECLARE_TR_FUNCTIONS(agv::model::CellInput)
public:
    /// A number from `least` to `most`. BadInput: a sentence in the language of the program that names
    /// `field` ("x of anchor A0"), quotes the text and says what fits.
    static Result<double> number(const QString& text, const QString& field, double least, double most);
    /// The same for a whole number.
    static Result<int> wholeNumber(const QString& text, const QString& field, int least, int most);

    /// Every digit that was entered, to be edited: no groups, at most six decimals.
    static QString editable(double value);
    /// Fixed decimals with the locale's groups and a minus sign; never "-0".
    static QString shown(double value, int decimals);
    /// A dash where there is no value.
    static QString shown(std::optional<double> value, int decimals);

    static const QString& none(); ///< the dash
};

// What the plant file takes, in mm.
inline constexpr double mostCoordinate_mm = 1e6;
inline constexpr int mostUwbNumber = 255; ///< of anchors and tags

inline constexpr double mmPerCm = 10.0; ///< corrections are read and written in cm

} // namespace agv::model
