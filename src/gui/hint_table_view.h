// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

namespace agv::gui {

/// A table that says why it is empty and how to fill it, instead of standing there blank.
class HintTableView : public QTableView {
    Q_OBJECT
public:
    explicit HintTableView(QWidget* parent = nullptr);

    void setHint(const QString& hint);
    QString hint() const { return m_hint; }
    bool showsHint() const;

    /// A table with a minimum height wants no more: it takes what is left, and its panel scrolls as late as
    /// it can.
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_hint;
};

} // namespace agv::gui
