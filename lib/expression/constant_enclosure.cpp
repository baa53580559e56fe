#include "expression/constant_enclosure.h"

#include "expression/tape_evaluator.h"
#include "interval/elementary.h"
#include "interval/mpfr_interval.h"

namespace gcslab {

Interval constant_enclosure(Expression value) {
  if (value.is_constant()) return elementary::enclosing(value.constant());
  constexpr int kBits = 128;
  const NumberTraits<MpfrInterval>::Scope scope(kBits);
  const Tape tape(value, 0);
  TapeEvaluator<MpfrInterval> evaluator(tape);
  evaluator.evaluate({});
  return NumberTraits<MpfrInterval>::enclosure(evaluator.value());
}

}  // namespace gcslab
