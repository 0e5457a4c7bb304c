#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "physics/methods/embedded_pair.hpp"
#include "physics/state.hpp"

namespace bounce {

/// A Runge-Kutta method of order 8 that estimates its own error, so that it can choose its step:
/// twelve force evaluations for a step whose error falls by 256 when it is halved. `rk4` with four
/// of them gets 16.
/// Source: DOP853 of Dormand and Prince, in Hairer, Norsett and Wanner, Solving Ordinary
/// Differential Equations I, 2nd edition (1993), section II.10, and its program dop853.f. The tests
/// check the numbers below: a wrong digit in any of them costs orders.
template <class Vector>
class Dop853 : public EmbeddedPair<Vector, 12> {
 public:
  /// A step of `h` from the start; it may be repeated with another `h`. The state holds until then.
  template <class Law>
  const State<Vector>& step(const Law& law, double t, double h);

  /// The error of the last step as it is estimated, in units of what `tolerance` allows.
  double error(double h, double tolerance) const {
    const Vector v5 = fifth(this->velocity_), v3 = third(this->velocity_);
    const Vector a5 = fifth(this->acceleration_), a3 = third(this->acceleration_);
    return this->in_units_allowed(h, tolerance, {v5, &v3}, {a5, &a3});
  }

  /// From that error, the step that would make it just right. The estimate is of order 7, that is,
  /// it falls as h^8; and 0.9 is caution.
  static double better_step(double h, double error) {
    const double ratio = 0.9 / std::sqrt(std::sqrt(std::sqrt(error)));
    return h * (ratio >= 0.2 ? std::min(ratio, 6.0) : 0.2);  // 0.2 as well if it is no number
  }

 private:
  using Slopes = typename EmbeddedPair<Vector, 12>::Slopes;  // the twelve

  // Two estimates, of order 5 and 3: differences to less accurate sums of the same slopes.
  static auto fifth(const Slopes& k) {
    return 0.1312004499419488073250102996e-1 * k[1] + -0.1225156446376204440720569753e1 * k[6] +
           -0.4957589496572501915214079952 * k[7] + 0.1664377182454986536961530415e1 * k[8] +
           -0.3503288487499736816886487290 * k[9] + 0.3341791187130174790297318841 * k[10] +
           0.8192320648511571246570742613e-1 * k[11] + -0.2235530786388629525884427845e-1 * k[12];
  }
  static auto third(const Slopes& k) {
    return eighth(k) + -0.244094488188976377952755905512 * k[1] +
           -0.733846688281611857341361741547 * k[9] + -0.220588235294117647058823529412e-1 * k[12];
  }
  static auto eighth(const Slopes& k) {
    return 5.42937341165687622380535766363e-2 * k[1] + 4.45031289275240888144113950566 * k[6] +
           1.89151789931450038304281599044 * k[7] + -5.8012039600105847814672114227 * k[8] +
           3.1116436695781989440891606237e-1 * k[9] + -1.52160949662516078556178806805e-1 * k[10] +
           2.01365400804030348374776537501e-1 * k[11] + 4.47106157277725905176885569043e-2 * k[12];
  }
};

template <class Vector>
template <class Law>
const State<Vector>& Dop853<Vector>::step(const Law& law, double t, double h) {
  const auto next = [&](std::size_t i, double c, const auto& sum) {
    this->slope(law, t, h, i, c, sum);
  };
  next(2, 0.526001519587677318785587544488e-1,
       [](const Slopes& k) { return 5.26001519587677318785587544488e-2 * k[1]; });
  next(3, 0.789002279381515978178381316732e-1, [](const Slopes& k) {
    return 1.97250569845378994544595329183e-2 * k[1] + 5.91751709536136983633785987549e-2 * k[2];
  });
  next(4, 0.118350341907227396726757197510, [](const Slopes& k) {
    return 2.95875854768068491816892993775e-2 * k[1] + 8.87627564304205475450678981324e-2 * k[3];
  });
  next(5, 0.281649658092772603273242802490, [](const Slopes& k) {
    return 2.41365134159266685502369798665e-1 * k[1] + -8.84549479328286085344864962717e-1 * k[3] +
           9.24834003261792003115737966543e-1 * k[4];
  });
  next(6, 1.0 / 3, [](const Slopes& k) {
    return 3.7037037037037037037037037037e-2 * k[1] + 1.70828608729473871279604482173e-1 * k[4] +
           1.25467687566822425016691814123e-1 * k[5];
  });
  next(7, 0.25, [](const Slopes& k) {
    return 3.7109375e-2 * k[1] + 1.70252211019544039314978060272e-1 * k[4] +
           6.02165389804559606850219397283e-2 * k[5] + -1.7578125e-2 * k[6];
  });
  next(8, 4.0 / 13, [](const Slopes& k) {
    return 3.70920001185047927108779319836e-2 * k[1] + 1.70383925712239993810214054705e-1 * k[4] +
           1.07262030446373284651809199168e-1 * k[5] + -1.53194377486244017527936158236e-2 * k[6] +
           8.27378916381402288758473766002e-3 * k[7];
  });
  next(9, 0.651282051282051282051282051282, [](const Slopes& k) {
    return 6.24110958716075717114429577812e-1 * k[1] + -3.36089262944694129406857109825 * k[4] +
           -8.68219346841726006818189891453e-1 * k[5] + 2.75920996994467083049415600797e1 * k[6] +
           2.01540675504778934086186788979e1 * k[7] + -4.34898841810699588477366255144e1 * k[8];
  });
  next(10, 0.6, [](const Slopes& k) {
    return 4.77662536438264365890433908527e-1 * k[1] + -2.48811461997166764192642586468 * k[4] +
           -5.90290826836842996371446475743e-1 * k[5] + 2.12300514481811942347288949897e1 * k[6] +
           1.52792336328824235832596922938e1 * k[7] + -3.32882109689848629194453265587e1 * k[8] +
           -2.03312017085086261358222928593e-2 * k[9];
  });
  next(11, 6.0 / 7, [](const Slopes& k) {
    return -9.3714243008598732571704021658e-1 * k[1] + 5.18637242884406370830023853209 * k[4] +
           1.09143734899672957818500254654 * k[5] + -8.14978701074692612513997267357 * k[6] +
           -1.85200656599969598641566180701e1 * k[7] + 2.27394870993505042818970056734e1 * k[8] +
           2.49360555267965238987089396762 * k[9] + -3.0467644718982195003823669022 * k[10];
  });
  next(12, 1, [](const Slopes& k) {
    return 2.27331014751653820792359768449 * k[1] + -1.05344954667372501984066689879e1 * k[4] +
           -2.00087205822486249909675718444 * k[5] + -1.79589318631187989172765950534e1 * k[6] +
           2.79488845294199600508499808837e1 * k[7] + -2.85899827713502369474065508674 * k[8] +
           -8.87285693353062954433549289258 * k[9] + 1.23605671757943030647266201528e1 * k[10] +
           6.43392746015763530355970484046e-1 * k[11];
  });
  this->state_.position = this->start_.position + h * eighth(this->velocity_);
  this->state_.velocity = this->start_.velocity + h * eighth(this->acceleration_);
  return this->state_;
}

}  // namespace bounce
