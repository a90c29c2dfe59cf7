// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "gui/application_setup.h"
#include "gui/result_text.h"
#include "gui/scenes.h"

#include <QApplication>
#include <QFile>
#include <QLocale>
#include <QRegularExpression>
#include <QXmlStreamReader>

using namespace agv;
using namespace agv::gui;

namespace {

// Unbreakable spaces stand between numbers and units; in expectations plain ones read better.
QString plain(QString text) { return text.replace(QChar(QChar::Nbsp), QLatin1Char(' ')); }

} // namespace

class TextTest : public QObject {
    Q_OBJECT
private slots:
    void init() { setUpApplication(*qApp, QLocale(QStringLiteral("en_GB"))); }
    void cleanupTestCase() { setUpApplication(*qApp, QLocale(QStringLiteral("en_GB"))); }
    void aGoodResultIsOneSentenceWithItsUncertainty();
    void theUncertaintyIsRoundedUpNeverDown();
    void theSuggestionSaysWhy();
    void aMeasuredTurnSuggestsNothing();
    void anAmbiguousResultNamesTheSecondPosition();
    void everyFlagHasItsReason_data();
    void everyFlagHasItsReason();
    void aFailedSolverSaysSo();
    void germanTextsAndNumbers();
    void theGermanTranslationIsComplete();
};

void TextTest::aGoodResultIsOneSentenceWithItsUncertainty()
{
    const auto estimate = scenes::goodEstimate();
    QCOMPARE(ResultText::verdict(*estimate), Verdict::Good);
    QCOMPARE(ResultText::headline(*estimate), QStringLiteral("Position found"));
    QCOMPARE(
        plain(ResultText::sentence(QStringLiteral("AGV 1"), *estimate)),
        QStringLiteral("AGV 1 stands at x 1,204 mm, y 873 mm and faces 92.3°. With 95 % certainty within "
                       "±3 mm and ±1.8°."));
    QVERIFY(ResultText::reasons(*estimate).isEmpty());
}

void TextTest::theUncertaintyIsRoundedUpNeverDown()
{
    const auto estimate = scenes::goodEstimate();
    estimate->covariance = {};
    estimate->covariance[0] = 1.2e-3 * 1.2e-3 / 5.991464547107979; // long half axis: 1.2 mm
    estimate->lastHeadingSd = 0.0;
    const QString text = plain(ResultText::sentence(QStringLiteral("AGV 1"), *estimate));
    QVERIFY2(text.endsWith(QStringLiteral("±2 mm and ±0.1°.")), qPrintable(text));
}

void TextTest::theSuggestionSaysWhy()
{
    QCOMPARE(plain(ResultText::suggestion(*scenes::goodEstimate(), 8)),
             QStringLiteral("The steps were 43.1° instead of 45.0°: a sleeptime of 1,175 ms fits (±10 ms)."));
}

void TextTest::aMeasuredTurnSuggestsNothing()
{
    const auto estimate = scenes::goodEstimate();
    estimate->suggestedTurnTime_s.reset();
    QVERIFY(ResultText::suggestion(*estimate, 8).isEmpty());
}

void TextTest::anAmbiguousResultNamesTheSecondPosition()
{
    const PlantSnapshot snapshot = scenes::ambiguous();
    const TurnEstimate& estimate = *snapshot.agvs[0].turn.result;
    QCOMPARE(ResultText::verdict(estimate), Verdict::Warning);
    QCOMPARE(ResultText::headline(estimate), QStringLiteral("Two positions are possible"));
    const QString reasons = plain(ResultText::reasons(estimate).join(QLatin1Char('\n')));
    QVERIFY2(reasons.contains(QStringLiteral("x 1,304 mm, y 947 mm")), qPrintable(reasons));
}

void TextTest::everyFlagHasItsReason_data()
{
    QTest::addColumn<int>("flag");
    for (TurnFlag flag :
         {TurnFlag::Weak, TurnFlag::Ambiguous, TurnFlag::FewReads, TurnFlag::WrongRotation,
          TurnFlag::UnevenSteps, TurnFlag::PoorFit, TurnFlag::NoReads, TurnFlag::NotConverged})
        QTest::newRow(toText(flag)) << static_cast<int>(flag);
}

void TextTest::everyFlagHasItsReason()
{
    QFETCH(int, flag);
    TurnEstimate estimate;
    estimate.valid = true;
    estimate.flags = {static_cast<TurnFlag>(flag)};
    const QStringList reasons = ResultText::reasons(estimate);
    QCOMPARE(reasons.size(), 1);
    QVERIFY(reasons[0].size() > 20);
}

void TextTest::aFailedSolverSaysSo()
{
    TurnEstimate estimate;
    estimate.status = "cancelled";
    QCOMPARE(ResultText::verdict(estimate), Verdict::Error);
    QCOMPARE(ResultText::headline(estimate), QStringLiteral("No position found"));
    QVERIFY(ResultText::reasons(estimate).join(QString()).contains(QStringLiteral("cancelled")));
}

void TextTest::germanTextsAndNumbers()
{
    setUpApplication(*qApp, QLocale(QStringLiteral("de_DE")));
    QCOMPARE(plain(ResultText::sentence(QStringLiteral("AGV 1"), *scenes::goodEstimate())),
             QStringLiteral("AGV 1 steht bei x 1.204 mm, y 873 mm und blickt nach 92,3°. Mit 95 % Sicherheit "
                            "innerhalb ±3 mm und ±1,8°."));
}

void TextTest::theGermanTranslationIsComplete()
{
    QFile file(QStringLiteral(AGV_SOURCE_DIR "/translations/agv-console_de.ts"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString source;
    int texts = 0;
    const QRegularExpression places(QStringLiteral("%\\d"));
    const auto countOf = [&places](const QString& text) { return text.count(places); };
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QLatin1String("source"))
            source = xml.readElementText();
        else if (xml.name() == QLatin1String("translation")) {
            const bool finished = xml.attributes().value(QLatin1String("type")).isEmpty();
            const QString german = xml.readElementText();
            ++texts;
            QVERIFY2(finished && !german.isEmpty(), qPrintable(source));
            QVERIFY2(countOf(german) == countOf(source), qPrintable(source + QStringLiteral(" / ") + german));
        }
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QVERIFY(texts > 300);
}

QTEST_MAIN(TextTest)
#include "test_texts.moc"
