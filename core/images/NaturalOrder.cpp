// SPDX-License-Identifier: Apache-2.0
#include "core/images/NaturalOrder.h"

#include <algorithm>
#include <limits>

namespace core {

namespace {

bool isDigit(QChar letter)
{
    return letter >= u'0' && letter <= u'9';
}

/// The digits from a place on, without zeros in front; moves the place behind them.
QStringView digitsAt(QStringView name, qsizetype& at)
{
    const qsizetype begin = at;
    while (at < name.size() && isDigit(name[at]))
        ++at;
    QStringView digits = name.mid(begin, at - begin);
    while (digits.size() > 1 && digits.front() == u'0')
        digits = digits.mid(1);
    return digits;
}

/// A name around the last of its numbers.
struct NumberedName {
    QString around; ///< before and behind it, apart by a sign that no name has
    qint64 number = 0;
};

std::optional<NumberedName> numbered(const QString& name)
{
    qsizetype end = name.lastIndexOf(u'.');
    if (end < 0)
        end = name.size();
    while (end > 0 && !isDigit(name[end - 1]))
        --end;
    qsizetype begin = end;
    while (begin > 0 && isDigit(name[begin - 1]))
        --begin;
    bool isNumber = false;
    const qint64 number = name.mid(begin, end - begin).toLongLong(&isNumber);
    if (!isNumber)
        return std::nullopt;
    return NumberedName{name.left(begin) + u'/' + name.mid(end), number};
}

} // namespace

bool comesBefore(const QString& name, const QString& other)
{
    qsizetype i = 0;
    qsizetype j = 0;
    while (i < name.size() && j < other.size()) {
        if (isDigit(name[i]) && isDigit(other[j])) {
            const QStringView a = digitsAt(name, i);
            const QStringView b = digitsAt(other, j);
            if (a.size() != b.size())
                return a.size() < b.size();
            if (a != b)
                return a < b;
            continue;
        }
        const QChar a = name[i++].toCaseFolded();
        const QChar b = other[j++].toCaseFolded();
        if (a != b)
            return a < b;
    }
    const bool isEnd = i == name.size();
    const bool isOtherEnd = j == other.size();
    return isEnd == isOtherEnd ? name < other : isEnd;
}

std::vector<NumberGap> numberGaps(const QStringList& names)
{
    std::vector<qint64> numbers;
    QString around;
    for (const QString& name : names) {
        const std::optional<NumberedName> parts = numbered(name);
        if (!parts || (!numbers.empty() && parts->around != around))
            return {};
        around = parts->around;
        numbers.push_back(parts->number);
    }
    qint64 step = std::numeric_limits<qint64>::max();
    for (std::size_t i = 1; i < numbers.size(); ++i)
        step = std::min(step, numbers[i] - numbers[i - 1]);
    std::vector<NumberGap> gaps;
    for (std::size_t i = 1; i < numbers.size() && step > 0; ++i) {
        const qint64 apart = numbers[i] - numbers[i - 1];
        if (apart % step != 0)
            return {};
        if (apart > step)
            gaps.push_back({.after = int(i) - 1, .missing = apart / step - 1});
    }
    return gaps;
}

} // namespace core
