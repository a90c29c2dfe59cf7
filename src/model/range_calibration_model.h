// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "core/plant_layout.h"
#include "core/uwb_snapshot.h"

#include <vector>

namespace agv::model {

/// What a calibration of the ranges of one tag has found so far, a row per anchor. GUI thread.
class RangeCalibrationModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Anchor, Count, Present, Found, Spread, ColumnCount };

    explicit RangeCalibrationModel(QObject* parent = nullptr);

    void setResult(const std::vector<UwbAnchor>& anchors, const std::vector<RangeCorrection>& corrections,
                   const RangeCalibrationSnapshot& calibration);
    void clear();

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString text(const RangeCalibrationRow& row, int column) const;

    std::vector<UwbAnchor> m_anchors;
    std::vector<RangeCorrection> m_corrections;
    RangeCalibrationSnapshot m_result;
};

/// The corrections with those of `calibration`, each in place of the present one of its pair.
std::vector<RangeCorrection> corrected(std::vector<RangeCorrection> corrections,
                                       const RangeCalibrationSnapshot& calibration);

} // namespace agv::model
