// The list: headings, cards, filters; and which card the comparator shows.
(() => {
  const at = id => document.getElementById(id);
  const data = JSON.parse(at('data').textContent);
  const names = {
    subject: data.subject, reference: data.reference, difference: 'Difference ×32',
    second: 'Second reference', second_difference: 'References ×32',
  };
  const kWorst = 20;

  // Rounded down: 100% means all.
  const percent = share => (Math.floor(share * 1e4) / 1e2).toFixed(2) + '%';
  const describe = f => f.equal === 1 ? 'equal in every pixel' :
    `${percent(f.equal)} equal, ${percent(f.within_1)} within 1/255, largest ${f.largest}/255`;
  const referencesDiffer = e => e.second && (e.second.complaint || e.second.with_reference.equal < 1);

  // The worst first: failing, then by the shares of pixels that are near.
  function compareWorst(a, b) {
    if (a.good !== b.good) return a.good - b.good;
    if (!a.figures || !b.figures) return !!a.figures - !!b.figures;
    for (const key of ['far', 'near', 'within_1', 'equal']) {
      if (a.figures[key] !== b.figures[key]) return a.figures[key] - b.figures[key];
    }
    return 0;
  }
  const worst = new Set([...data.entries].sort(compareWorst).slice(0, kWorst));

  const filters = {
    all: {name: 'All', test: () => true},
    failing: {name: 'Failing', test: e => !e.good},
    worst: {name: 'Worst', test: e => worst.has(e), sort: compareWorst},
    unequal: {name: 'Not equal', test: e => !e.figures || e.figures.equal < 1},
    loose: {name: 'With a reason', test: e => e.tolerance.reason},
    references: {name: 'References differ', test: referencesDiffer},
  };
  let filter = 'all', shown = [], open = -1;

  function make(tag, attributes, ...children) {
    const node = Object.assign(document.createElement(tag), attributes);
    node.append(...children);
    return node;
  }

  function tolerance(t) {
    if (t.near_share === 1 && t.near === 0) return 'Tolerance: every pixel equal.';
    const far = t.far === t.near ? '' : `, ${t.far_share === 1 ? 'all' : percent(t.far_share)} within ${t.far}/255`;
    return `Tolerance: ${percent(t.near_share)} of the pixels within ${t.near}/255${far}.` +
      (t.reason ? ` Because: ${t.reason}.` : '');
  }

  function second(e) {
    if (!referencesDiffer(e)) return null;
    const cause = e.second.cause ? ` Because: ${e.second.cause}.` : '';
    if (e.second.complaint) return `${e.second.name}: ${e.second.complaint}.${cause}`;
    return `The references differ. ${e.second.name} with ${e.reference_name}: ${describe(e.second.with_reference)}; ` +
      `with ${data.subject}: ${describe(e.second.with_subject)}.${cause}`;
  }

  function lines(e) {
    const list = [];
    if (e.complaint) list.push(['complaint', e.complaint]);
    if (e.figures) list.push(['figures', describe(e.figures)]);
    list.push(['faint', tolerance(e.tolerance)]);
    if (e.reference_name) list.push(['faint', `Reference: ${e.reference_name}.`]);
    if (e.note) list.push(['note', e.note]);
    if (second(e)) list.push(['note', second(e)]);
    return list.map(([className, text]) => make('p', {className}, text));
  }

  function card(e) {
    const node = make('article', {className: e.good ? 'card' : 'card bad'},
      make('h4', {}, e.name, make('span', {className: 'verdict'}, e.good ? 'within' : 'failing')));
    if (e.pictures) {
      const pictures = make('button', {type: 'button', className: 'pictures', title: 'Compare'},
        ...['subject', 'reference', 'difference'].map(which => make('div', {},
          make('img', {src: e.pictures[which], alt: `${e.name}: ${names[which]}`, loading: 'lazy', width: e.size[0], height: e.size[1]}),
          make('span', {}, names[which]))));
      pictures.addEventListener('click', () => view(shown.indexOf(e)));
      node.append(pictures);
    }
    node.append(...lines(e));
    return node;
  }

  function list() {
    const text = at('search').value.trim().toLowerCase();
    const {test, sort} = filters[filter];
    shown = data.entries.filter(e => test(e) && e.name.toLowerCase().includes(text));
    if (sort) shown.sort(sort);
    const nodes = [];
    let chapter = null, section = null, cards = null;
    for (const e of shown) {
      if (!sort && e.chapter !== chapter) nodes.push(make('h2', {}, e.chapter));
      if (!cards || (!sort && (e.chapter !== chapter || e.section !== section))) {
        if (!sort && e.section) nodes.push(make('h3', {}, e.section));
        nodes.push(cards = make('div', {className: 'cards'}));
      }
      ({chapter, section} = e);
      cards.append(card(e));
    }
    at('entries').replaceChildren(...nodes);
    at('nothing').hidden = shown.length > 0;
    for (const button of at('filters').children) {
      button.setAttribute('aria-pressed', button.dataset.filter === filter);
    }
  }

  function view(index) {
    const e = shown[index];
    if (!e || !e.pictures) return;
    open = index;
    at('viewer-name').textContent = e.name;
    at('viewer-figures').replaceChildren(...lines(e));
    const {subject, reference, difference} = e.pictures;
    const pictures = {subject, reference, difference};
    if (e.second && e.second.picture) {
      pictures.second = e.second.picture;
      pictures.second_difference = e.second.difference;
    }
    comparator.show(pictures, names, e.size);
    if (!at('viewer').open) at('viewer').showModal();
  }

  // The next entry in a direction that has pictures.
  function step(by) {
    let index = open + by;
    while (shown[index] && !shown[index].pictures) index += by;
    view(index);
  }

  at('title').textContent = document.title = data.title;
  const failing = data.entries.filter(e => !e.good).length;
  const equal = data.entries.filter(e => e.figures && e.figures.equal === 1).length;
  const differ = data.entries.filter(referencesDiffer).length;
  at('summary').textContent = `${data.entries.length} compared, ${failing} failing, ${equal} equal in every pixel` +
    (data.entries.some(e => e.second) ? `; the references differ in ${differ}.` : '.');
  at('messages').append(...data.messages.map(text => make('li', {}, text)));
  for (const [key, {name, test}] of Object.entries(filters)) {
    const count = data.entries.filter(test).length;
    if (count === 0 && !['all', 'failing'].includes(key)) continue;
    const button = make('button', {type: 'button'}, `${name} ${count}`);
    button.dataset.filter = key;
    button.addEventListener('click', () => { filter = key; list(); });
    at('filters').append(button);
  }
  at('search').addEventListener('input', list);
  at('previous').addEventListener('click', () => step(-1));
  at('next').addEventListener('click', () => step(1));
  at('close').addEventListener('click', () => at('viewer').close());
  at('viewer').addEventListener('close', comparator.stop);
  at('viewer').addEventListener('keydown', event => {
    if (event.target.type === 'range') return;
    if (event.key === 'ArrowLeft') step(-1);
    if (event.key === 'ArrowRight') step(1);
  });
  list();
})();
