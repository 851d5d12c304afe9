// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/NodeStatus.h"

namespace core {

namespace {

Clause words(std::uint16_t status)
{
    switch (status) {
    case 0x0110:
        return Clause::saying("it failed while it worked on it");
    case 0x0122:
        return Clause::saying("it does not take this kind of object");
    case 0x0124:
        return Clause::saying("it does not allow us to");
    case 0xa801:
        return Clause::saying("it does not know where to send to");
    case 0xfe00:
        return Clause::saying("it was called off there");
    default:
        break;
    }
    switch (status >> 8) {
    case 0xa7:
        return Clause::saying("it is out of resources");
    case 0xa9:
        return Clause::saying("the object is not what it expects");
    case 0xb0:
        return Clause::saying("some of it did not succeed");
    default:
        return (status >> 12) == 0xc ? Clause::saying("it does not understand")
                                     : Clause::saying("no reason that DICOM knows");
    }
}

} // namespace

Clause statusText(std::uint16_t status)
{
    return Clause::saying("%1 (0x%2)", words(status),
        QStringLiteral("%1").arg(uint(status), 4, 16, QLatin1Char('0')));
}

} // namespace core
