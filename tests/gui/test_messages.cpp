// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "estimation/fusion/vehicle_tracker.h"
#include "estimation/uwb/anchor_survey.h"
#include "estimation/uwb/anchor_watch.h"
#include "gui/application_setup.h"
#include "link/failure_text.h"
#include "link/serial_failure_text.h"
#include "model/messages.h"
#include "procedure/link_life.h"
#include "procedure/range_calibration.h"
#include "procedure/turn_parameters.h"
#include "procedure/uwb_handshake.h"
#include "session/jog_text.h"
#include "session/uwb_link.h"
#include "session/uwb_tag_track.h"

#include <QApplication>
#include <QMetaEnum>

#include <algorithm>
#include <chrono>
#include <cmath>

using namespace agv;
using model::Messages;

/// The sentences of the modules below, in German.
class MessagesTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { gui::setUpApplication(*qApp, QLocale(QStringLiteral("de_DE"))); }
    void valuesAreCarriedOver();
    void aSentenceInASentenceIsTranslatedToo();
    void aValueThatLooksLikeAPlaceIsNotFilledIn();
    void unknownSentencesStayAsTheyAre();
    void droppedMessagesAreCountedInGerman();
    void everyConnectionFailureHasItsGermanSentence();
    void everyListenFailureHasItsGermanSentence();
    void everyReasonOfALinkHasItsGermanSentence_data();
    void everyReasonOfALinkHasItsGermanSentence();
    void everySerialFailureHasItsGermanSentence();
    void whyAUwbUnitIsNotKnownHasItsGermanSentence();
    void whatASurveyOfTheAnchorsSaysHasItsGermanSentence();
    void whyAUwbTagHasNoPositionHasItsGermanSentence();
    void whatToKnowOfARangeCalibrationHasItsGermanSentence();
    void whyAPoseIsDoubtedHasItsGermanSentence();
    void whyAnAnchorIsDoubtedHasItsGermanSentence();
    void whatAUwbUnitIsHasItsGermanSentence();
    void whyAHandDoesNotDriveHasItsGermanSentence();
    void everyBadParameterHasItsGermanSentence();
    void whereASleeptimeIsKeptHasItsGermanSentence();

private:
    static void checkTranslated(const std::string& english)
    {
        const QString german = Messages::sentence(english);
        QVERIFY2(german != QString::fromStdString(english), english.c_str());
        QVERIFY2(!german.contains(QLatin1Char('%')), qPrintable(german));
    }
};

void MessagesTest::valuesAreCarriedOver()
{
    QCOMPARE(Messages::sentence("The robot connected from 127.0.0.2:4711"),
             QStringLiteral("Der Roboter hat sich von 127.0.0.2:4711 verbunden"));
    QCOMPARE(Messages::sentence("The robot was stopped 31 ms late: this computer was busy, the step is about "
                                "1.2 degrees too long"),
             QStringLiteral("Der Roboter wurde 31 ms zu spät angehalten: Dieser Rechner war ausgelastet, der "
                            "Schritt ist etwa 1.2 Grad zu lang"));
    QCOMPARE(Messages::source("RFID reader 12"), QStringLiteral("RFID-Leser 12"));
}

void MessagesTest::aSentenceInASentenceIsTranslatedToo()
{
    QCOMPARE(Messages::sentence("The link to the robot was lost: 127.0.0.2:4711 no longer answers: check its "
                                "power and its Wi-Fi"),
             QStringLiteral("Die Verbindung zum Roboter ist verloren: 127.0.0.2:4711 antwortet nicht mehr: "
                            "Strom und WLAN des Geräts prüfen"));
}

void MessagesTest::aValueThatLooksLikeAPlaceIsNotFilledIn()
{
    QCOMPARE(Messages::sentence("Connection to %2 failed: %1"),
             QStringLiteral("Verbindung zu %2 gescheitert: %1"));
}

void MessagesTest::unknownSentencesStayAsTheyAre()
{
    for (const char* text : {"", "A robot's own words (17)", "100 % sure", "The robot connected from "})
        QCOMPARE(Messages::sentence(text), QString::fromLatin1(text));
}

void MessagesTest::droppedMessagesAreCountedInGerman()
{
    QCOMPARE(Messages::drops("3 noise, 12 over-long"), QStringLiteral("3 Rauschen, 12 zu lang"));
}

void MessagesTest::everyConnectionFailureHasItsGermanSentence()
{
    const auto errors = QMetaEnum::fromType<QAbstractSocket::SocketError>();
    QVERIFY(errors.keyCount() > 20);
    for (int i = 0; i < errors.keyCount(); ++i) {
        for (bool wasConnected : {false, true})
            checkTranslated(
                link::connectionFailureText(static_cast<QAbstractSocket::SocketError>(errors.value(i)),
                                            wasConnected, {"10.0.0.7", 8883}, QStringLiteral("x"))
                    .toStdString());
    }
}

void MessagesTest::everyListenFailureHasItsGermanSentence()
{
    for (auto error : {QAbstractSocket::AddressInUseError, QAbstractSocket::SocketAccessError,
                       QAbstractSocket::SocketAddressNotAvailableError, QAbstractSocket::UnknownSocketError})
        checkTranslated(link::listenFailure(error, "TCP", {"127.0.0.1", 2001}, QStringLiteral("x")).detail);
}

void MessagesTest::everyReasonOfALinkHasItsGermanSentence_data()
{
    QTest::addColumn<bool>("isUwb");
    QTest::newRow("RFID reader") << false;
    QTest::newRow("UWB unit") << true;
}

void MessagesTest::everyReasonOfALinkHasItsGermanSentence()
{
    QFETCH(bool, isUwb);
    procedure::LinkLifeParameters parameters;
    if (isUwb)
        parameters.hints = session::UwbLinkParameters::usualLife().hints;
    procedure::LinkLife life(parameters);
    Time now{};
    int reasons = 0;
    // A device that takes connections but never says a word, then one that takes none.
    for (int i = 0; i < 400; ++i) {
        now += std::chrono::milliseconds(100);
        if (life.state() == LinkState::Down)
            life.open(now);
        else if (life.state() == LinkState::Opening && i < 200)
            life.connected(now);
        life.onTimer(now);
        if (!life.reason().empty()) {
            checkTranslated(life.reason());
            ++reasons;
        }
    }
    QVERIFY(reasons > 100);
}

void MessagesTest::everySerialFailureHasItsGermanSentence()
{
    using link::SerialFault;
    for (const SerialFault fault : {SerialFault::Missing, SerialFault::Busy, SerialFault::Forbidden,
                                    SerialFault::NotSerial, SerialFault::Unplugged, SerialFault::Other}) {
        for (const char* port : {"/dev/ttyACM0", "USB 0483:5740, serial number 3061"}) {
            for (const char* group : {"", "dialout"})
                checkTranslated(link::serialFailureText(fault, port, group, "x").toStdString());
        }
    }
    QCOMPARE(Messages::sentence(
                 link::serialFailureText(SerialFault::Missing, "USB 0483:5740, serial number 3061", {}, {})
                     .toStdString()),
             QStringLiteral("Die serielle Schnittstelle USB 0483:5740, Seriennummer 3061 gibt es nicht: die "
                            "Einheit einstecken oder eine andere Schnittstelle wählen"));
}

void MessagesTest::whyAUwbUnitIsNotKnownHasItsGermanSentence()
{
    const Time start{};
    procedure::UwbHandshake foreign;
    foreign.opened(false, start);
    checkTranslated(foreign.reason());
    procedure::UwbHandshake clone;
    clone.opened(true, start);
    clone.bytes("x", UwbDialect::UlmFour, start);
    checkTranslated(clone.reason());
    procedure::UwbHandshake mute;
    mute.opened(true, start);
    for (int i = 1; i < 20; ++i)
        mute.onTimer(start + std::chrono::seconds(i));
    checkTranslated(mute.reason());
}

void MessagesTest::whatASurveyOfTheAnchorsSaysHasItsGermanSentence()
{
    const std::vector<UwbAnchor> anchors{{0, "A0", 0.0, 0.0, 2.0, true}, {1, "A1", 4.0, 0.0, 2.0, true},
                                         {2, "A2", 0.0, 3.0, 2.0, true}, {3, "A3", 4.0, 3.0, 2.0, true},
                                         {4, "A4", 2.0, 5.0, 2.0, true}, {5, "A5", 3.0, 5.0, 2.0, true}};
    const auto pair = [](int first, int second, double range_m) {
        return AnchorPairSnapshot{
            .first = first, .second = second, .range_m = range_m, .sd_m = 0.03, .count = 100};
    };
    const std::vector<AnchorPairSnapshot> triangle{pair(0, 1, 4.0), pair(0, 2, 3.0), pair(1, 2, 5.0)};
    const auto check = [&](std::vector<AnchorPairSnapshot> pairs, const std::vector<UwbAnchor>& listed,
                           std::size_t notes) {
        const AnchorSurvey survey = estimation::surveyAnchors(pairs, listed);
        QCOMPARE(survey.notes.size(), notes);
        QCOMPARE(survey.anchors.empty(), !survey.trouble.empty());
        if (!survey.trouble.empty())
            checkTranslated(survey.trouble);
        for (const std::string& note : survey.notes)
            checkTranslated(note);
    };
    const auto with = [&](const std::vector<AnchorPairSnapshot>& more) {
        std::vector<AnchorPairSnapshot> pairs = triangle;
        pairs.insert(pairs.end(), more.begin(), more.end());
        return pairs;
    };
    check({}, {}, 0);
    check({}, anchors, 0);
    check({pair(0, 1, 4.0)}, anchors, 1);                                   // too few, others silent
    check({pair(0, 1, 4.0), pair(0, 2, 8.0), pair(1, 2, 4.0)}, anchors, 1); // on one line
    check(with({pair(1, 3, 3.0), pair(2, 3, 4.0), pair(0, 4, 5.4), pair(0, 9, 1.0)}), anchors, 4);
    check(with({pair(1, 3, 3.0), pair(2, 3, 4.0), pair(0, 3, 6.5)}), anchors, 7); // long, the others short
    std::vector<UwbAnchor> high = anchors;
    high[0].z = 9.0;
    check(triangle, high, 0);
    check(with({pair(1, 3, 3.0), pair(2, 3, 4.0), pair(0, 3, 12.0)}), anchors, 1); // fits no arrangement
}

void MessagesTest::whyAUwbTagHasNoPositionHasItsGermanSentence()
{
    const std::vector<UwbAnchor> anchors{
        {0, "A0", 0.0, 0.0, 2.0, true}, {1, "A1", 3.0, 0.0, 2.0, true}, {2, "A2", 6.0, 0.0, 2.0, true}};
    const auto reasonFor = [&](std::vector<std::int32_t> heard, double later_s) {
        protocol::RangeSet ranges;
        for (const std::int32_t anchor : heard)
            ranges.add({.time_s = 10.0, .range_m = 2.0 + anchor, .anchor = anchor});
        session::UwbTagTrack track({}, anchors);
        track.take(ranges, 10.0);
        return track.snapshot(10.0 + later_s).reason;
    };
    checkTranslated(reasonFor({0, 1}, 0.1));
    checkTranslated(reasonFor({0, 7}, 0.1));
    checkTranslated(reasonFor({0, 1, 2}, 0.1)); // on one line
    checkTranslated(reasonFor({0, 1}, 12.0));
}

void MessagesTest::whatToKnowOfARangeCalibrationHasItsGermanSentence()
{
    const std::vector<UwbAnchor> anchors{{1, "A1", 0.0, 0.0, 2.0, true}, {2, "A2", 3.0, 0.0, 2.0, true}};
    const auto reasonFor = [&](double seconds, const std::vector<double>& ranges_m) {
        procedure::RangeCalibration calibration;
        calibration.start(3, {2.0, 0.0, 2.0}, anchors, seconds, Time{});
        for (const double range_m : ranges_m)
            calibration.add({.range_m = range_m, .tag = 3, .anchor = 1}, Time{});
        calibration.onTimer(Time{} + std::chrono::minutes(20));
        return calibration.snapshot(Time{}).reason;
    };
    const std::vector<double> exact(20, 2.0);
    const std::vector<double> wrong(20, 3.5);
    std::vector<double> scattered(20, 2.0);
    std::fill(scattered.begin(), scattered.begin() + 8, 2.6);
    checkTranslated(reasonFor(0.1, exact));
    checkTranslated(reasonFor(30.0, {}));
    checkTranslated(reasonFor(30.0, {2.0, 2.0}));
    checkTranslated(reasonFor(30.0, exact)); // anchor 2 was not heard
    checkTranslated(reasonFor(30.0, wrong));
    checkTranslated(reasonFor(30.0, scattered));
    procedure::RangeCalibration calibration;
    calibration.start(3, {}, {}, 30.0, Time{});
    checkTranslated(calibration.snapshot(Time{}).reason);
    calibration.start(3, {std::nan(""), 0.0, 0.0}, anchors, 30.0, Time{});
    checkTranslated(calibration.snapshot(Time{}).reason);
    checkTranslated("The anchors were changed meanwhile: start the calibration again");
}

void MessagesTest::whyAPoseIsDoubtedHasItsGermanSentence()
{
    PlantLayout plant;
    plant.agvs.emplace_back();
    estimation::VehicleTracker tracker(plant, plant.agvs.front());
    tracker.start({}, {1e-6, 0, 0, 0, 1e-6, 0, 0, 0, 1e-4}, Time{});
    tracker.wheels({0.1, 0.1}, Time{});
    checkTranslated(tracker.pose(Time{} + std::chrono::seconds(9)).note); // predicted
    for (const char* sentence :
         {"It drove by itself to dock or undock: calibrate it again",
          "The link to the robot was lost while it drove: calibrate it again",
          "The floor tags it reads lie elsewhere: it was moved or slipped; calibrate it again",
          "Its UWB tag is elsewhere: it was moved; calibrate it again"})
        checkTranslated("Its pose is doubted. " + std::string(sentence));
}

void MessagesTest::whyAnAnchorIsDoubtedHasItsGermanSentence()
{
    using estimation::AnchorDoubtKind;
    const auto doubtOf = [](AnchorDoubtKind kind) {
        return estimation::AnchorDoubt{.index = 2, .kind = kind, .amount_m = 0.32, .displacement = {}};
    };
    for (const AnchorDoubtKind kind :
         {AnchorDoubtKind::Moved, AnchorDoubtKind::TooLong, AnchorDoubtKind::TooShort})
        checkTranslated(estimation::toText(doubtOf(kind)));
    QCOMPARE(
        Messages::sentence("Anchor 2: " + estimation::toText(doubtOf(AnchorDoubtKind::Moved))),
        QStringLiteral("Anker 2: Die Abstände passen zu einem Ort 320 mm neben dem in der Liste: den Anker "
                       "neu einmessen oder zurückstellen"));
}

void MessagesTest::whatAUwbUnitIsHasItsGermanSentence()
{
    QCOMPARE(Messages::sentence("The unit is Ver.2.25mx TREK: anchor 0, channel 2, 6.81 Mb/s"),
             QStringLiteral("Die Einheit ist Ver.2.25mx TREK: Anker 0, Kanal 2, 6.81 Mb/s"));
}

void MessagesTest::whyAHandDoesNotDriveHasItsGermanSentence()
{
    for (int i = int(JogReason::None) + 1; i <= int(JogReason::BadSpeed); ++i) {
        const std::string why = session::sentenceOf(JogReason(i));
        QVERIFY(!why.empty());
        checkTranslated(why);
        checkTranslated("It does not drive: " + why);
        checkTranslated("Stopped: " + why);
        checkTranslated("Driving by hand ended: " + why);
    }
    for (const DockOrder order : {DockOrder::Dock, DockOrder::Undock, DockOrder::Charge}) {
        checkTranslated("It was told to " + session::nameOf(order));
        checkTranslated("It does not " + session::nameOf(order) + ": the robot is not connected");
    }
    for (const char* sentence : {"Driven by hand, with the keys", "Driven by hand, with the pad",
                                 "It was told to stop", "Stop was pressed"})
        checkTranslated(sentence);
}

void MessagesTest::everyBadParameterHasItsGermanSentence()
{
    TurnParameters wrong[5];
    wrong[0].stopsPerTurn = 9;
    wrong[1].turnTime_s = -1.0;
    wrong[2].wheelSpeed_m_s = 99.0;
    wrong[3].settle_s = -1.0;
    wrong[4].maxDwell_s = 1e9;
    for (const TurnParameters& parameters : wrong) {
        const Result<void> result = procedure::validate(parameters);
        QVERIFY(!result);
        checkTranslated(result.error().detail);
    }
}

void MessagesTest::whereASleeptimeIsKeptHasItsGermanSentence()
{
    QCOMPARE(Messages::sentence("Sleeptime 1201 ms is written to hall 2.json; there it was 1125 ms"),
             QStringLiteral("Sleeptime 1201 ms ist in hall 2.json geschrieben; dort stand 1125 ms"));
    QCOMPARE(Messages::sentence("The sleeptime holds for this session only: the plant is simulated"),
             QStringLiteral("Die Sleeptime gilt nur für diese Sitzung: Die Anlage ist simuliert"));
    checkTranslated("The sleeptime holds for this session only: there is no plant file");
    checkTranslated(
        "The wheel speed was not changed: Wheel speed is 300 mm/s: it must lie between 10 mm/s and 250 mm/s");
}

QTEST_MAIN(MessagesTest)
#include "test_messages.moc"
