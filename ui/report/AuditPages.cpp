// SPDX-License-Identifier: Apache-2.0
#include "ui/report/AuditPages.h"

#include "ui/report/PaperText.h"

#include <QImage>
#include <QPainter>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace ui {

namespace {

// Millimetres on A4.
constexpr double pageWidth = 210.0;
constexpr double left = 15.0;
constexpr double textWidth = 180.0;
constexpr double top = 24.0;
constexpr double bottom = 276.0;
constexpr double headerAt = 12.0;
constexpr double footerAt = 281.0;
constexpr int picturesPerRow = 3;
constexpr double pictureGap = 6.0;

const QColor ink{0x1b, 0x1f, 0x24};
const QColor quiet{0x5b, 0x64, 0x70};
const QColor gone{0x7a, 0x83, 0x8e};
const QColor note{0x8a, 0x5a, 0x00};
const QColor rule{0xdf, 0xe3, 0xe8};
const QColor accent{0x22, 0x66, 0xa8};

struct Column {
    const char* head;
    double at;
    double width;
    Qt::Alignment alignment = Qt::AlignLeft;
};
const std::array<Column, 6> columns{
    Column{"#", 0.0, 9.0, Qt::AlignRight},
    Column{"When (UTC)", 13.0, 34.0},
    Column{"Who", 50.0, 26.0},
    Column{"What", 79.0, 53.0},
    Column{"How much", 133.0, 25.0, Qt::AlignRight},
    Column{"State", 162.0, 18.0},
};

/// Texts with their places, relative to the top left of a block, in pixels.
using Texts = std::vector<std::pair<QPointF, PaperText>>;

double heightOf(const Texts& texts)
{
    double height = 0.0;
    for (const auto& [at, text] : texts)
        height = std::max(height, at.y() + text.height());
    return height;
}

void paintTexts(QPainter& painter, const Texts& texts, const QPointF& topLeft)
{
    for (const auto& [at, text] : texts)
        text.paint(painter, topLeft + at);
}

} // namespace

AuditPages::AuditPages(const AuditTexts& texts, const QSizeF& sizePixels)
    : m_size(sizePixels)
    , m_runningTitle(QStringLiteral("Burin · ") + texts.title.toLower())
    , m_file(texts.session.empty() ? QString() : texts.session.front().value)
    , m_footer(texts.footer)
{
    add(tableHead());
    addTitle(texts);
    addFacts(texts);
    addVerdict(texts);
    addSegments(texts);
    addHeading(QStringLiteral("Steps"));
    addSteps(texts);
    addHeading(QStringLiteral("Pictures"));
    addSentence(texts.pictures.empty() ? texts.noPictures : texts.aboutPictures);
    addPictures(texts.pictures);
    place();
}

double AuditPages::mm(double millimetres) const
{
    return millimetres * m_size.width() / pageWidth;
}

double AuditPages::points(double count) const
{
    return mm(count * 25.4 / 72.0);
}

QRectF AuditPages::contentBox() const
{
    return {mm(left), mm(top), mm(textWidth), mm(bottom - top)};
}

void AuditPages::add(Block block)
{
    m_blocks.push_back(std::move(block));
}

// --- Blocks --------------------------------------------------------------------------------------

void AuditPages::addTitle(const AuditTexts& texts)
{
    const double point = points(1.0);
    const PaperText title(texts.title, mm(textWidth), point, {.sizePoints = 22.0, .bold = true});
    const PaperText words(
        texts.subtitle, mm(textWidth), point, {.sizePoints = 9.5, .colour = quiet});
    const Texts placed{{{0.0, 0.0}, title}, {{0.0, title.height() + mm(1.0)}, words}};
    const double height = heightOf(placed) + mm(4.0);
    add({.height = height, .paint = [this, placed, height](QPainter& painter, double at) {
             paintTexts(painter, placed, {mm(left), at});
             painter.fillRect(
                 QRectF(mm(left), at + height - mm(0.6), mm(textWidth), mm(0.6)), accent);
         }});
}

void AuditPages::addFacts(const AuditTexts& texts)
{
    addHeading(QStringLiteral("Study"));
    addFactLines(texts.study);
    addHeading(QStringLiteral("Session"));
    addFactLines(texts.session);
}

void AuditPages::addFactLines(const std::vector<AuditTexts::Fact>& facts)
{
    constexpr double nameWidth = 34.0;
    const double point = points(1.0);
    for (const AuditTexts::Fact& fact : facts) {
        const PaperText name(fact.name, mm(nameWidth - 2.0), point, {.colour = quiet});
        const PaperText value(fact.value, mm(textWidth - nameWidth), point,
            {.sizePoints = fact.isHash ? 8.0 : 8.5, .fixedPitch = fact.isHash});
        const Texts placed{{{0.0, 0.0}, name}, {{mm(nameWidth), 0.0}, value}};
        add({.height = heightOf(placed) + mm(0.8),
            .paint = [this, placed](QPainter& painter, double at) {
                paintTexts(painter, placed, {mm(left), at});
            }});
    }
}

void AuditPages::addVerdict(const AuditTexts& texts)
{
    const double point = points(1.0);
    const QColor strong = texts.sound ? QColor(0x1f, 0x6b, 0x39) : QColor(0xa3, 0x2d, 0x20);
    const QColor ground = texts.sound ? QColor(0xee, 0xf7, 0xf0) : QColor(0xfc, 0xef, 0xed);
    const QColor bar = texts.sound ? QColor(0x2c, 0x8a, 0x4b) : QColor(0xc2, 0x3b, 0x2c);
    constexpr double inset = 5.0;
    const PaperText verdict(texts.verdict, mm(textWidth - 2.0 * inset), point,
        {.sizePoints = 10.0, .colour = strong, .bold = true});
    // What is damaged stands at its end, so it is cut only where it would fill more than a page.
    constexpr qsizetype longest = 3000;
    const PaperText words(
        texts.explanation, mm(textWidth - 2.0 * inset), point, {.longest = longest});
    const Texts placed{
        {{mm(inset), mm(3.0)}, verdict}, {{mm(inset), mm(4.0) + verdict.height()}, words}};
    const double height = heightOf(placed) + mm(3.0);
    add({.height = height,
        .spaceBefore = mm(6.0),
        .paint = [this, placed, height, ground, bar](QPainter& painter, double at) {
            painter.fillRect(QRectF(mm(left), at, mm(textWidth), height), ground);
            painter.fillRect(QRectF(mm(left), at, mm(1.2), height), bar);
            paintTexts(painter, placed, {mm(left), at});
        }});
}

void AuditPages::addHeading(const QString& text)
{
    const PaperText words(
        text, mm(textWidth), points(1.0), {.sizePoints = 11.0, .colour = ink, .bold = true});
    add({.height = words.height() + mm(2.0),
        .spaceBefore = mm(6.0),
        .paint =
            [this, words](QPainter& painter, double at) {
                words.paint(painter, {mm(left), at});
            },
        .keepWithNext = true});
}

void AuditPages::addSentence(const QString& text)
{
    const PaperText words(text, mm(textWidth), points(1.0), {.colour = quiet});
    add({.height = words.height() + mm(1.2),
        .spaceBefore = mm(1.2),
        .paint = [this, words](QPainter& painter, double at) {
            words.paint(painter, {mm(left), at});
        }});
}

AuditPages::Block AuditPages::tableHead() const
{
    Texts placed;
    for (const Column& column : columns)
        placed.emplace_back(QPointF(mm(column.at), 0.0),
            PaperText(QLatin1String(column.head), mm(column.width), points(1.0),
                {.sizePoints = 8.0, .colour = quiet, .bold = true, .alignment = column.alignment}));
    const double height = heightOf(placed) + mm(1.6);
    return {.height = height,
        .paint =
            [this, placed, height](QPainter& painter, double at) {
                paintTexts(painter, placed, {mm(left), at});
                painter.fillRect(
                    QRectF(mm(left), at + height - mm(0.3), mm(textWidth), mm(0.3)), quiet);
            },
        .keepWithNext = true};
}

AuditPages::Block AuditPages::stepBlock(const AuditTexts::Step& step) const
{
    const double point = points(1.0);
    const double above = mm(1.4);
    Texts placed;
    const std::array<const QString*, 6> cells{
        &step.number, &step.when, &step.who, &step.what, &step.howMuch, &step.hash};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const bool isHash = i + 1 == columns.size();
        // Smaller words on the same line as the others.
        const double lower = isHash ? points(1.3) : 0.0;
        placed.emplace_back(QPointF(mm(columns[i].at), above + lower),
            PaperText(*cells[i], mm(columns[i].width), point,
                {.sizePoints = isHash ? 7.0 : 8.5,
                    .colour = step.stands ? (i == 3 ? ink : quiet) : gone,
                    .fixedPitch = isHash,
                    .alignment = columns[i].alignment}));
    }
    if (!step.note.isEmpty()) {
        const Column& what = columns[3];
        const QPointF below(mm(what.at), above + placed[3].second.height());
        placed.emplace_back(below,
            PaperText(step.note, mm(what.width), point, {.sizePoints = 7.5, .colour = note}));
    }
    const double height = heightOf(placed) + mm(1.6);
    return {.height = height,
        .paint =
            [this, placed, height](QPainter& painter, double at) {
                paintTexts(painter, placed, {mm(left), at});
                painter.fillRect(
                    QRectF(mm(left), at + height - mm(0.2), mm(textWidth), mm(0.2)), rule);
            },
        .isStep = true};
}

void AuditPages::addSteps(const AuditTexts& texts)
{
    if (texts.steps.empty())
        return addSentence(texts.noSteps);
    add(m_blocks.front());
    for (const AuditTexts::Step& step : texts.steps)
        add(stepBlock(step));
}

void AuditPages::addSegments(const AuditTexts& texts)
{
    if (texts.aboutSegments.isEmpty())
        return;
    addHeading(QStringLiteral("Segments"));
    addSentence(texts.aboutSegments);
    std::vector<AuditTexts::Fact> facts;
    for (const AuditTexts::Segment& segment : texts.segments)
        facts.push_back({segment.name,
            segment.change.isEmpty() ? segment.size : segment.size + u'\n' + segment.change});
    addFactLines(facts);
    if (!texts.changes.empty()) {
        addSentence(texts.aboutChanges);
        addPictures(texts.changes);
    }
}

void AuditPages::addPictures(const std::vector<AuditTexts::Picture>& pictures)
{
    const double side = (textWidth - pictureGap * (picturesPerRow - 1)) / picturesPerRow;
    for (std::size_t first = 0; first < pictures.size(); first += picturesPerRow) {
        struct Cell {
            QRectF box;
            QByteArray png;
        };
        std::vector<Cell> cells;
        Texts placed;
        const std::size_t end = std::min(first + picturesPerRow, pictures.size());
        for (std::size_t i = first; i < end; ++i) {
            const AuditTexts::Picture& picture = pictures[i];
            const double x = mm((side + pictureGap) * double(i - first));
            const QSize size = QImage::fromData(picture.png).size();
            const double tall = size.isEmpty()
                ? mm(10.0)
                : std::min(mm(side) * size.height() / size.width(), mm(side));
            const double wide = size.isEmpty() ? mm(side) : tall * size.width() / size.height();
            cells.push_back({QRectF(x, 0.0, wide, tall), picture.png});
            const PaperText caption(picture.caption, mm(side), points(1.0), {.sizePoints = 8.0});
            const PaperText hash(QStringLiteral("SHA-256 %1\n        %2")
                                     .arg(picture.sha256.left(32), picture.sha256.mid(32)),
                mm(side), points(1.0), {.sizePoints = 5.5, .colour = quiet, .fixedPitch = true});
            placed.emplace_back(QPointF(x, tall + mm(1.2)), caption);
            placed.emplace_back(QPointF(x, tall + mm(1.8) + caption.height()), hash);
        }
        add({.height = heightOf(placed),
            .spaceBefore = mm(first == 0 ? 3.0 : 5.0),
            .paint = [this, cells, placed](QPainter& painter, double at) {
                painter.setRenderHint(QPainter::SmoothPixmapTransform);
                for (const Cell& cell : cells) {
                    const QRectF box = cell.box.translated(mm(left), at);
                    painter.fillRect(box, Qt::black);
                    painter.drawImage(box, QImage::fromData(cell.png));
                }
                paintTexts(painter, placed, {mm(left), at});
            }});
    }
}

// --- Pages ---------------------------------------------------------------------------------------

void AuditPages::place()
{
    const QRectF box = contentBox();
    double at = box.top();
    int page = 0;
    const auto put = [&](std::size_t block) {
        m_placed.push_back({page, at, block});
        at += m_blocks[block].height;
    };
    for (std::size_t i = 1; i < m_blocks.size(); ++i) {
        const Block& block = m_blocks[i];
        // A heading takes what it heads along; the head of a table and its first row, too.
        double needed = block.height;
        for (std::size_t next = i; m_blocks[next].keepWithNext && next + 1 < m_blocks.size();)
            needed += m_blocks[++next].height;
        const bool first = at == box.top();
        const double before = first ? 0.0 : block.spaceBefore;
        if (!first && at + before + needed > box.bottom()) {
            ++page;
            at = box.top();
            if (block.isStep)
                put(0);
        } else {
            at += before;
        }
        put(i);
    }
    m_count = page + 1;
}

std::vector<AuditPages::Place> AuditPages::stepPlaces() const
{
    std::vector<Place> places;
    for (const Placed& placed : m_placed) {
        const Block& block = m_blocks[placed.block];
        if (block.isStep)
            places.push_back(
                {placed.page, QRectF(mm(left), placed.top, mm(textWidth), block.height)});
    }
    return places;
}

void AuditPages::paint(QPainter& painter, int page) const
{
    const double point = points(1.0);
    const PaperText::Style small{.sizePoints = 7.5, .colour = quiet};
    PaperText::Style smallRight = small;
    smallRight.alignment = Qt::AlignRight;
    const QPointF header(mm(left), mm(headerAt));
    PaperText(m_runningTitle, mm(textWidth), point, small).paint(painter, header);
    PaperText(m_file, mm(textWidth), point, smallRight).paint(painter, header);
    const QPointF footer(mm(left), mm(footerAt));
    painter.fillRect(QRectF(mm(left), mm(footerAt - 2.0), mm(textWidth), mm(0.2)), rule);
    PaperText(m_footer, mm(textWidth), point, small).paint(painter, footer);
    PaperText(QStringLiteral("Page %1 of %2").arg(page + 1).arg(m_count), mm(textWidth), point,
        smallRight)
        .paint(painter, footer);
    for (const Placed& placed : m_placed) {
        if (placed.page == page)
            m_blocks[placed.block].paint(painter, placed.top);
    }
}

} // namespace ui
