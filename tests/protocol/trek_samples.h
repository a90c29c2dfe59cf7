// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/trek_stream.h"

#include <string>
#include <vector>

/// One line of each form and dialect, as units print them.
namespace agv::protocol::samples {

inline const std::string trek = "mc 0f 00000663 000005a3 00000512 000004cb 095f c1 00024c24 a0:0";
inline const std::string trekRaw = "mr 0f 00000663 000005a3 00000512 000004cb 095f c1 40414041 a0:0";
inline const std::string trekAnchors = "ma 0e 00000000 000006d9 0000069c 0000026b 6cbd 51 00a0641e a0:0";
inline const std::string trekThree = "mc 07 000004ec 000008ee 0000087e 00000000 6cc0 0a 00a0642b a12:0";
inline const std::string trekOld = "ma03 t01 00000650 000005e7 0003 02 00003a82 404f 404f a0";
inline const std::string ulmFour = "mc 00 00000807 00000991 ffffffff 0000095e 00b6 b7 00021332 t0:0 1f40";
inline const std::string ulmEight = "mc 00 00000807 00000991 00000815 0000095e 00000001 00000000 ffffffff "
                                    "000009a4 00b6 b7 00021332 a01:0 0000";
inline const std::string ulmText = "$NKT0,2.06,2.45,null,2.40,LO=[no solution]";
inline const std::string esp32 = "mc 0b 00000807 00000991 00000000 0000095e 00b6 b7 00000000 t0:0";
inline const std::string imuFour = "mi,981.937,0.63,null,1.25,NULL,-2.777783,1.655664,9.075048,-0.004788,"
                                   "-0.014364,-0.001596,T0";
inline const std::string imuEight = "mi,77.690,0.69,0.65,0.90,0.94,null,null,null,null,-0.129,0.033,9.676,"
                                    "-0.000,-0.002,-0.000,25.650,2.850,13.950,-0.012,1.018,-4.479,T3";

inline const std::vector<std::string> trekReports{trek,    trekRaw,  trekAnchors, trekThree, trekOld,
                                                  ulmFour, ulmEight, esp32,       imuFour,   imuEight};

/// What a stream gave: its reports without the values that depend on the dialect, and its counts.
struct Heard {
    std::vector<TrekReport> reports;
    TrekStream::Counts counts;
    UwbDialect dialect = UwbDialect::Unknown;
    friend bool operator==(const Heard&, const Heard&) = default;
};

/// Feeds `bytes` cut at the given places, each piece 1 ms later than the one before.
inline Heard hear(std::string_view bytes, const std::vector<std::size_t>& cuts = {}, bool keepTimes = false)
{
    TrekStream stream;
    Heard heard;
    Time now{};
    std::size_t begin = 0;
    const auto take = [&](const TrekReport& report) {
        heard.reports.push_back(report);
        if (!keepTimes)
            heard.reports.back().firstByte = Time{};
    };
    for (const std::size_t cut : cuts) {
        stream.feed(bytes.substr(begin, cut - begin), now += std::chrono::milliseconds(1), take);
        begin = cut;
    }
    stream.feed(bytes.substr(begin), now += std::chrono::milliseconds(1), take);
    heard.counts = stream.counts();
    heard.dialect = stream.dialect().dialect();
    return heard;
}

inline Heard hearInBursts(std::string_view bytes, std::size_t size)
{
    std::vector<std::size_t> cuts;
    for (std::size_t cut = size; cut < bytes.size(); cut += size)
        cuts.push_back(cut);
    return hear(bytes, cuts);
}

} // namespace agv::protocol::samples
