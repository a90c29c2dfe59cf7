// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"

#include <filesystem>
#include <string>
#include <vector>

/// The seed's emulator (appendix A): an ideal robot turns on the spot over a grid of tags and writes down
/// what its reader would see at each stop. No noise, no time: test input for solvers.
namespace agv::simulation {

struct EmulatorOptions {
    int columns = 11; ///< tags along x; tag 1 lies at (0, 0), numbers count along y first
    int rows = 11;
    double pitch_m = 0.100;
    Point2 centre{0.225, 0.515}; ///< of the robot, m (the seed's example)
    double bearing =
        radFromDeg(22.5);           ///< centre to antenna at the first stop, rad, counter-clockwise from +x
    double antennaRadius_m = 0.100; ///< centre to antenna
    double step = radFromDeg(45.0); ///< rad, counter-clockwise, between stops
    int stops = 9;                  ///< the closing one included
    RssiTable table = seedRssiTable();
    bool readerLike = false; ///< SCAN:+UID=...+RSSI=n<\r> after the angle; false: number and RSSI alone
    bool changesOnly =
        false; ///< a line only where a tag's RSSI changed since the last stop; out of range counts as 0
    bool hexadecimal = false; ///< tag numbers as 16 hexadecimal digits
    int fileNumber = 11;      ///< in the names of the files
};

struct EmulatorReading {
    int tag = 0; ///< number, 1-based
    int rssi = 0;
    friend bool operator==(const EmulatorReading&, const EmulatorReading&) = default;
};

/// Tags in range at each stop, by number. BadInput: a field, step or number of stops that makes no sense.
Result<std::vector<std::vector<EmulatorReading>>> emulateTurn(const EmulatorOptions& options);

/// The readings file, one line per reading: angle since the first stop in degrees, tag, RSSI.
/// Unlike the seed's program, which repeats the RSSI of another tag there, `changesOnly` writes 0 for a tag
/// that left.
Result<std::string> emulatorText(const EmulatorOptions& options);

/// The side file, one value a line: number of tags, length of the field along x (cm), first bearing (rad), x
/// and y of the robot (cm).
std::string emulatorSideText(const EmulatorOptions& options);

struct EmulatorPaths {
    std::filesystem::path readings; ///< Meas_StartingProc_like_reader_real_data11.txt
    std::filesystem::path side;     ///< NumTags11.txt
};

/// Writes both files, making the folder if need be. BadInput as above, or when there is no reading at all;
/// Io: the file that cannot be written, and why.
Result<EmulatorPaths> writeEmulatorFiles(const std::filesystem::path& folder, const EmulatorOptions& options);

} // namespace agv::simulation
