// The comparator: two pictures in one place, with a divider that moves, or in turns, or one alone.
'use strict';

const comparator = (() => {
  const at = id => document.getElementById(id);
  const kBlinkMilliseconds = 500;
  let pictures = null, names = null, mode = null, timer = 0, second = false;

  // Shows `first` alone, or with the part right of the divider covered by `second`.
  function place(left, right) {
    at('below').src = pictures[left];
    at('below').alt = at('label-left').textContent = names[left];
    at('above').hidden = at('divider').hidden = at('slider').hidden = at('label-right').hidden = !right;
    if (!right) return;
    at('above').src = pictures[right];
    at('above').alt = at('label-right').textContent = names[right];
  }

  function blink() {
    second = !second;
    place(second ? 'reference' : 'subject');
  }

  function divide(share) {
    const held = Math.min(Math.max(share, 0), 1);
    at('slider').value = Math.round(held * 1000);
    at('stage').style.setProperty('--at', held * 100 + '%');
  }

  function choose(next) {
    clearInterval(timer);
    mode = next;
    for (const button of at('modes').children) {
      button.setAttribute('aria-pressed', button.dataset.mode === mode);
    }
    if (mode === 'slider') place('subject', 'reference');
    else if (mode !== 'blink') place(mode);
    else {
      second = true;
      blink();
      timer = setInterval(blink, kBlinkMilliseconds);
    }
  }

  function drag(event) {
    if (mode !== 'slider' || !(event.buttons & 1)) return;
    const box = at('stage').getBoundingClientRect();
    divide((event.clientX - box.left) / box.width);
  }
  at('stage').addEventListener('pointerdown', event => { at('stage').setPointerCapture(event.pointerId); drag(event); });
  at('stage').addEventListener('pointermove', drag);
  at('slider').addEventListener('input', event => divide(event.target.value / 1000));

  return {
    // The pictures and their names, both by subject, reference, difference; others may follow.
    show(nextPictures, nextNames, size) {
      pictures = nextPictures;
      names = nextNames;
      at('stage').style.setProperty('--aspect', size[0] / size[1]);
      const modes = ['slider', 'blink', ...Object.keys(pictures)];
      at('modes').replaceChildren(...modes.map(name => {
        const button = document.createElement('button');
        button.type = 'button';
        button.dataset.mode = name;
        button.textContent = names[name] || name[0].toUpperCase() + name.slice(1);
        button.addEventListener('click', () => choose(name));
        return button;
      }));
      divide(0.5);
      choose(modes.includes(mode) ? mode : 'slider');
    },
    stop() { clearInterval(timer); },
  };
})();
