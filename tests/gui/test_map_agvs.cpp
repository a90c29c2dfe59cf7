// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "gui/map/map_widget.h"
#include "gui/scenes.h"

using namespace agv;
using namespace agv::gui;

class MapAgvTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void anAgvThatDroveOnIsDrawnWhereItIsNowAndNotWhereItsTurnWas();
    void anAgvWhosePoseIsDoubtedLooksSoAndSaysWhy();

private:
    MapWidget m_map;
};

void MapAgvTest::init()
{
    m_map.setPlant(scenes::wholePlant());
    m_map.resize(900, 700);
    m_map.show();
}

void MapAgvTest::anAgvThatDroveOnIsDrawnWhereItIsNowAndNotWhereItsTurnWas()
{
    PlantSnapshot snapshot = scenes::finished();
    AgvSnapshot& agv = snapshot.agvs[0];
    const Point2 turnedAt = agv.turn.result->pose.position;
    agv.pose = Pose2{{turnedAt.x - 0.6, turnedAt.y}, 0.0};
    m_map.showSnapshot(snapshot);
    QVERIFY(
        m_map.detailsAt(m_map.viewport().toPixels(agv.pose->position)).startsWith(QStringLiteral("AGV 1")));
    QVERIFY(!m_map.detailsAt(m_map.viewport().toPixels(turnedAt)).contains(QStringLiteral("stop")));
}

void MapAgvTest::anAgvWhosePoseIsDoubtedLooksSoAndSaysWhy()
{
    PlantSnapshot snapshot = scenes::finished();
    AgvSnapshot& agv = snapshot.agvs[1];
    m_map.showSnapshot(snapshot);
    const QImage before = m_map.grab().toImage();
    agv.poseHealth = PoseHealth::Doubted;
    agv.poseNote = "It drove by itself to dock or undock: calibrate it again";
    m_map.showSnapshot(snapshot);
    QVERIFY(m_map.grab().toImage() != before);
    QVERIFY(m_map.detailsAt(m_map.viewport().toPixels(agv.pose->position))
                .contains(QStringLiteral("It drove by itself to dock or undock: calibrate it again")));
}

QTEST_MAIN(MapAgvTest)
#include "test_map_agvs.moc"
