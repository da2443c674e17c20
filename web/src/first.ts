// The first list on the page: that of its link, or one with a mistake.
import type { Incoming } from './incoming';
import type { Shared } from './link';

const list = `kopf.achs_nr                   1
kopf.log_achs_name             X
kenngr.achs_typ                1
filter[0].enable               1
filter[0].type                 LOWPASS
filter[0].prototype            BUTTERWORTH
filter[0].order                2
filter[0].fg_f0                42,5
filter_fir.enable              1
filter_fir.type                1
filter_fir.order               20
`;

export function firstFiles(shared: Shared | null): Incoming {
  return [[shared?.name ?? 'x.lis', new TextEncoder().encode(shared?.text ?? list)]];
}
