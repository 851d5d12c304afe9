// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/report/AuditTexts.h"

#include <QRectF>
#include <QSizeF>

#include <functional>
#include <vector>

class QPainter;

namespace ui {

/// The audit report laid out on paper. What belongs together (a row of the table, a row of
/// pictures) is not broken across pages; the table's header is repeated; every page has its number.
///
/// It needs fonts but no window, so it may be used on any thread and for any paint device of the
/// given size.
class AuditPages {
public:
    /// @param sizePixels a whole page of A4
    AuditPages(const AuditTexts& texts, const QSizeF& sizePixels);

    [[nodiscard]] int count() const { return m_count; }
    void paint(QPainter& painter, int page) const;

    /// The place of each row of the table, in order, in pixels.
    struct Place {
        int page = 0;
        QRectF box;
    };
    [[nodiscard]] std::vector<Place> stepPlaces() const;
    /// The area between header and footer.
    [[nodiscard]] QRectF contentBox() const;

private:
    struct Block {
        double height = 0.0;
        double spaceBefore = 0.0; ///< left out at the top of a page
        std::function<void(QPainter&, double top)> paint;
        bool isStep = false;
        bool keepWithNext = false;
    };
    struct Placed {
        int page = 0;
        double top = 0.0;
        std::size_t block = 0;
    };

    [[nodiscard]] double mm(double millimetres) const;
    [[nodiscard]] double points(double count) const;
    void add(Block block);
    void addTitle(const AuditTexts& texts);
    void addFacts(const AuditTexts& texts);
    void addFactLines(const std::vector<AuditTexts::Fact>& facts);
    void addSegments(const AuditTexts& texts);
    void addVerdict(const AuditTexts& texts);
    void addHeading(const QString& text);
    void addSentence(const QString& text);
    void addSteps(const AuditTexts& texts);
    void addPictures(const std::vector<AuditTexts::Picture>& pictures);
    [[nodiscard]] Block stepBlock(const AuditTexts::Step& step) const;
    [[nodiscard]] Block tableHead() const;
    void place();

    QSizeF m_size;
    QString m_runningTitle;
    QString m_file;
    QString m_footer;
    std::vector<Block> m_blocks; ///< [0] is the table's head
    std::vector<Placed> m_placed;
    int m_count = 1;
};

} // namespace ui
