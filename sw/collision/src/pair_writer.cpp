// pair_writer.cpp - see pair_writer.h
#include "pair_writer.h"

namespace collision::detail {

PairWriter PairWriter::larger(std::size_t places) const {
    const std::size_t written = used();
    list_->resize(written + places);
    PairWriter writer(*list_);
    writer.next += written;
    return writer;
}

}  // namespace collision::detail
