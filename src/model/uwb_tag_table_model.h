// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "core/plant_layout.h"
#include "core/uwb_snapshot.h"

#include <optional>
#include <vector>

namespace agv::model {

/// "T0", or "UWB tag 0" where the list has no label.
QString uwbTagName(const UwbTag& tag);

/// The UWB tags: those of the list in its order, then others that are heard, by number. Where each is, how
/// sure that is, its ranges (a column per anchor), or why it has no position. GUI thread. Lengths in mm.
/// Label, AGV and height are edited as in AnchorTableModel; editing a tag that is only heard lists it.
class UwbTagTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Id, Label, Agv, Height, X, Y, Uncertainty, Age, Rate, Repeatability, State, FirstRange };
    enum Role {
        WarningRole = Qt::UserRole, ///< bool, the cell needs attention
        TagRole,                    ///< int, number of the tag
        ListedRole,                 ///< bool, the tag is in the list
        ChoicesRole,                ///< QStringList, what the cell may be; not set: anything
    };

    explicit UwbTagTableModel(QObject* parent = nullptr);

    void setAgvs(const std::vector<AgvConfig>& agvs) { m_agvs = agvs; }
    void setSettings(const std::vector<UwbAnchor>& anchors, const UwbSettings& settings);
    /// Null: nothing is known of the unit.
    void setSnapshot(const UwbSnapshot* uwb);
    const UwbTag& tag(int row) const { return m_rows[static_cast<std::size_t>(row)].tag; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
    /// `what` names the edit for the undo list.
    void editRequested(const QString& what, const std::vector<agv::UwbTag>& tags);
    /// Input that cannot be used; a sentence in the language of the program.
    void refused(const QString& sentence);

private:
    struct Row {
        UwbTag tag;
        bool listed = false;
        std::optional<UwbTagSnapshot> heard;
        friend bool operator==(const Row&, const Row&) = default;
    };
    std::vector<Row> rowsNow() const;
    void update();
    bool takeOverIds(const std::vector<Row>& rows);
    const UwbRangeSnapshot* range(const Row& row, int column) const;
    QString text(const Row& row, int column) const;
    QString rangeText(const Row& row, int column) const;
    QString stateText(const Row& row) const;
    QString toolTip(const Row& row, int column) const;
    QString rangeToolTip(const Row& row, int column) const;
    QString agvName(int number) const;
    Result<UwbTag> changed(int row, int column, const QString& input) const;
    Result<std::optional<RobotId>> agvFrom(const QString& input, const QString& name) const;

    std::vector<AgvConfig> m_agvs;
    std::vector<UwbAnchor> m_anchors;
    UwbSettings m_settings;
    std::vector<UwbTagSnapshot> m_heard;
    std::vector<Row> m_rows;
};

} // namespace agv::model
