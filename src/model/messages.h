// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

namespace agv::model {

/// The sentences of the lower modules in the language of the program. Those modules know no Qt and write
/// plain English (log files stay searchable that way); here each of their sentences is known by its pattern,
/// and the parts that differ ("%1") are taken from the text and, where they are sentences themselves,
/// translated in turn. A sentence without a pattern is shown as it is.
class Messages {
public:
    /// `english` as written by session, procedure or link.
    static QString sentence(const std::string& english);
    /// "Console", "AGV 1", "RFID reader 2"
    static QString source(const std::string& english);
    /// "3 garbled, 1 over-long"
    static QString drops(const std::string& english);
};

} // namespace agv::model
