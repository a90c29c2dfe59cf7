// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "core/plant_layout.h"
#include "core/uwb_settings.h"

#include <vector>

namespace agv::model {

/// What is added to the measured ranges: a row per anchor, a column per tag, cm with one decimal; an empty
/// cell adds nothing. GUI thread. Edited as AnchorTableModel is.
class CorrectionTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    static constexpr double most_cm = 1000.0; ///< of a correction; a larger one is a mistake

    explicit CorrectionTableModel(QObject* parent = nullptr);

    /// Tags of the list, `heard` ones and those that have a correction, by number.
    void setSettings(const std::vector<UwbAnchor>& anchors, const UwbSettings& settings,
                     const std::vector<int>& heard);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
    /// `what` names the edit for the undo list.
    void editRequested(const QString& what, const std::vector<agv::RangeCorrection>& corrections);
    /// Input that cannot be used; a sentence in the language of the program.
    void refused(const QString& sentence);

private:
    const RangeCorrection* correction(const QModelIndex& index) const;
    QString pairName(const QModelIndex& index) const;

    std::vector<UwbAnchor> m_anchors;
    std::vector<UwbTag> m_tags;
    std::vector<RangeCorrection> m_corrections;
};

} // namespace agv::model
